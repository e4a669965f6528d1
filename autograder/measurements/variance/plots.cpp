// The data of lab 1's plots: digits kept and time taken, for each way to a variance.

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"
#include "checks/variance/data_sets.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::checks {
namespace {

constexpr std::array<unsigned, 5> tasks{2, 3, 4, 5, 8};

double clamped_digits(double got, double exact) {
  return std::clamp(digits(got, exact), 0.0, 16.0);  // a plot needs no more, and no less
}

TEST_CASE("plot digits kept against the offset", "[.plot]") {
  constexpr std::size_t sets = 5, n = 1000;
  Rng rng(1);  // the same data for every submission, so that their lines can be compared
  std::vector<double> offsets, exact;
  Values all;
  for (double exponent = 0; exponent <= 15; exponent += 0.5) {
    offsets.push_back(std::pow(10, exponent));
    for (std::size_t set = 0; set < sets; ++set) {
      // offset + values uniform in [0,1), rounded as doubles are
      const auto x = uniform_values(rng, n, offsets.back(), offsets.back() + 1);
      exact.push_back(exact_moments(x).variance);
      all.insert(all.end(), x.begin(), x.end());
    }
  }
  std::vector<std::array<std::optional<double>, tasks.size() + 1>> rows(offsets.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i][0] = offsets[i];
  for (std::size_t task = 0; task < tasks.size(); ++task) {
    const auto got = TRY_MEASURE(variances, tasks[task], all, n);  // a column is there or is not
    const auto* found = got ? got->if_exactly(exact.size(), any_number) : nullptr;
    for (std::size_t i = 0; found && i < exact.size(); ++i) {
      auto& mean = rows[i / sets][task + 1];
      mean = mean.value_or(0) + clamped_digits((*found)[i], exact[i]) / static_cast<double>(sets);
    }
  }
  auto file = plot_file("digits.tsv");
  for (const auto& row : rows) plot_row(file, row);
}

/// 4,096 values near 1e9, 32 KB: they stay in the first-level cache. A case and a file for each
/// way: what is measured is drawn, whatever becomes of the others.
void plot_speed(unsigned task) {
  Rng rng(2);
  const auto x = uniform_values(rng, 4096, 1e9, 1e9 + 1);
  std::optional<double> kept, nanoseconds;
  const auto got = TRY_MEASURE(variances, task, x, x.size());
  if (const auto* variance = got ? got->if_exactly(1, any_number) : nullptr) {
    kept = clamped_digits(variance->front(), exact_moments(x).variance);
    const auto round = seconds_a_round(
        [&](std::uint64_t rounds) -> std::optional<double> {
          const auto timed = TRY_MEASURE(repeat, task, x, rounds, 1);
          if (!timed) return {};
          return timed->cpu_seconds;
        },
        0.025);
    if (round) nanoseconds = *round * 1e9 / static_cast<double>(x.size());
  }
  auto file = plot_file(fmt::format("speed-{}.tsv", task));
  plot_row(file, std::array{std::optional<double>(task), nanoseconds, kept});
}

TEST_CASE("plot time against digits of the textbook formula", "[.plot]") {
  plot_speed(2);
}
TEST_CASE("plot time against digits of two passes", "[.plot]") {
  plot_speed(3);
}
TEST_CASE("plot time against digits of Welford's update", "[.plot]") {
  plot_speed(4);
}
TEST_CASE("plot time against digits of merged parts", "[.plot]") {
  plot_speed(5);
}
TEST_CASE("plot time against digits of the fast moments", "[.plot]") {
  plot_speed(8);
}

}  // namespace
}  // namespace mc::checks
