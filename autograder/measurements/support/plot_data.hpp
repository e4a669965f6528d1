#pragma once
// What a plot is drawn from. A plot's data are made by a hidden test case, TEST_CASE("plot …",
// "[.plot]"), with the same measurements in the same jail as a check; labs/N-name/plots.gp draws
// them.

#include <algorithm>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "checks/support/measure.hpp"

namespace mc::checks {

/// The data file `name` of the plots that are being drawn: "points-1.tsv" is of the picture
/// "points".
std::ofstream plot_file(const std::string& name);

/// One row of a data file; what is missing is NaN, which gnuplot leaves out.
void plot_row(std::ostream& file, std::span<const std::optional<double>> values);

/// Seconds a round, seen from outside the program: the CPU time of 2R rounds less that of R, R so
/// large that the difference is 50 ms at least (or `least`); the median of five such figures, since
/// noise falls on either run. `run` gives the CPU time of so many rounds, or nothing.
template <class Run>
std::optional<double> seconds_a_round(Run run, double least = 0.05) {
  std::uint64_t rounds = 1;
  for (;; rounds *= 2) {
    const std::optional<double> once = run(rounds);
    if (!once) return {};
    if (*once >= least) break;
  }
  std::vector<double> differences;
  for (int i = 0; i < 5; ++i) {
    const auto one = run(rounds), two = run(2 * rounds);
    if (!one || !two) return {};
    differences.push_back((*two - *one) / static_cast<double>(rounds));
  }
  std::sort(differences.begin(), differences.end());
  if (differences[2] <= 0) return {};
  return differences[2];
}

}  // namespace mc::checks
