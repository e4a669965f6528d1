// The data of lab 1's plots: digits kept and time taken, for each way to a variance.

#include <algorithm>
#include <array>
#include <cmath>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/plot_data.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;

constexpr std::array<unsigned, 5> tasks{2, 3, 4, 5, 8};

/// offset + values uniform in [0,1), rounded as doubles are.
Values shifted_values(Rng& rng, double offset, std::size_t n) {
  return uniform_values(rng, n, offset, offset + 1);
}

/// Digits of the variance that task 1.`task` keeps, from none to 16: a plot needs no more.
std::optional<double> digits_kept(unsigned task, const Values& x, double exact) {
  const auto got = TRY_MEASURE(repeat, task, x, 1);
  if (!got) return {};
  return std::clamp(digits(got->value, exact), 0.0, 16.0);
}

TEST_CASE("plot digits kept against the offset", "[.plot]") {
  auto file = plot_file("digits.tsv");
  Rng rng(1);  // the same data for every submission, so that their lines can be compared
  constexpr int sets = 5;
  for (double exponent = 0; exponent <= 15; exponent += 0.5) {
    std::array<std::optional<double>, tasks.size() + 1> row{std::pow(10, exponent)};
    for (int set = 0; set < sets; ++set) {
      const auto x = shifted_values(rng, *row[0], 1000);
      const double exact = exact_moments(x).variance;
      for (std::size_t i = 0; i < tasks.size(); ++i) {
        const auto kept = digits_kept(tasks[i], x, exact);
        if (kept) row[i + 1] = row[i + 1].value_or(0) + *kept / sets;
      }
    }
    plot_row(file, row);
  }
}

TEST_CASE("plot time against digits kept", "[.plot]") {
  auto file = plot_file("speed.tsv");
  Rng rng(2);
  const auto x = shifted_values(rng, 1e9, 4096);  // 32 KB: in the first-level cache
  const double exact = exact_moments(x).variance;
  for (const unsigned task : tasks) {
    const auto round = seconds_a_round([&](std::uint64_t rounds) -> std::optional<double> {
      const auto got = TRY_MEASURE(repeat, task, x, rounds);
      if (!got) return {};
      return got->cpu_seconds;
    });
    std::optional<double> nanoseconds;
    if (round) nanoseconds = *round * 1e9 / static_cast<double>(x.size());
    plot_row(file,
             std::array{std::optional<double>(task), nanoseconds, digits_kept(task, x, exact)});
  }
}

}  // namespace
}  // namespace mc::checks
