// The data of lab 2's plots. The same seeds for every submission, so that their lines can be
// compared. Where a task is not written, or fails, its line is missing and nothing else.

#include <algorithm>
#include <array>
#include <cmath>

#include "2-independent/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/rect_light_exact.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::checks {
namespace {

using experiments::Function;
using Row = std::vector<std::optional<double>>;

constexpr std::uint64_t plot_seed = 1;

/// Integrands of the plots and their means, in the order of the columns.
struct Plotted {
  Function g;
  double mean;
};
const double sqrt_half = std::sqrt(0.5);
const std::array<Plotted, 5> integrands{{{{1, 0, 1, 0}, std::exp(1.0) - 1},  // exp(x)
                                         {{3, sqrt_half, 1, 0}, sqrt_half},  // x < sqrt(1/2)
                                         {{3, 0.01, 1, 0}, 0.01},            // x < 0.01
                                         {{4, -0.4, 1, 0}, 1 / 0.6},         // x^-0.4
                                         {{4, -0.75, 1, 0}, 4}}};            // x^-0.75

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Root of the mean squared distance from `exact`; NaN where there is nothing, or NaN in it.
template <class Range, class Value>
double rms_error(const Range& estimates, double exact, Value value) {
  double sum = 0;
  for (const auto& one : estimates) sum += (value(one) - exact) * (value(one) - exact);
  return std::sqrt(sum / static_cast<double>(estimates.size()));
}

/// Nanoseconds of a round: for an axis of time, noise of a few per cent is nothing.
std::optional<double> plotted_seconds(
    const std::function<std::optional<double>(std::uint64_t)>& run) {
  return seconds_a_round(run, 0.008);
}

TEST_CASE("plot error against samples", "[.plot]") {
  auto file = plot_file("error.tsv");
  for (std::uint64_t n = 4; n <= 65536; n *= 4) {
    // Two of three medians of 201 errors are off by 8 % at most, of 101 by 12 %: 4 pixels.
    const std::uint64_t replicates = n <= 4096 ? 201 : 101;
    Row row{static_cast<double>(n)};
    for (const auto& [g, mean] : integrands) {
      // Medians: where the variance is infinite, a mean square says how long one waited.
      const auto got = TRY_MEASURE(estimates, g, n, plot_seed, replicates);
      const auto* const all = got ? got->if_exactly(replicates) : nullptr;
      std::vector<double> errors;
      if (all != nullptr) {
        for (const auto& one : *all) errors.push_back(std::abs(one.value / mean - 1));
      }
      row.push_back(errors.empty() ? std::nullopt : std::optional(median(errors)));
    }
    plot_row(file, row);
  }
}

TEST_CASE("plot coverage against samples", "[.plot]") {
  auto file = plot_file("coverage.tsv");
  const std::uint64_t replicates = 500;  // a standard error of 1 % at 95 %
  const double level = 0.95, z = normal_quantile((1 + level) / 2);
  for (std::uint64_t n = 2; n <= 8192; n *= 2) {
    // Of normal values it is known: Student's t within z.
    Row row{static_cast<double>(n), f_tails(z * z, 1, static_cast<double>(n - 1)).lower};
    std::vector<Plotted> all{{{6, 0, 1, 0}, 0}};
    all.insert(all.end(), integrands.begin() + 2, integrands.end());
    for (const auto& [g, mean] : all) {
      const auto got = TRY_MEASURE(confidence_intervals, g, n, level, plot_seed, replicates);
      const auto* const intervals = got ? got->if_exactly(replicates, any_number) : nullptr;
      double covering = 0;
      if (intervals != nullptr) {
        for (const Interval& one : *intervals) covering += one.low <= mean && mean <= one.high;
      }
      row.push_back(intervals != nullptr ? std::optional(covering / replicates) : std::nullopt);
    }
    plot_row(file, row);
  }
}

TEST_CASE("plot intervals of sixty estimates", "[.plot]") {
  auto file = plot_file("intervals.tsv");
  const double z = normal_quantile(0.975);
  for (const auto& [g, mean] : {integrands[0], integrands[4]}) {
    const auto got = TRY_MEASURE(estimates, g, 1000, plot_seed, 60);
    const auto* const measured = got ? got->if_exactly(60) : nullptr;
    std::vector<experiments::Counted> all(1, {NAN, NAN, 0, 0});
    if (measured != nullptr) all = *measured;
    std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.value < b.value; });
    double rank = 0;
    for (const auto& one : all) {
      const double reach = z * one.standard_error;
      const double covers = std::abs(one.value - mean) <= reach ? 1 : 0;
      plot_row(file, Row{++rank, one.value / mean, reach / mean, covers});
    }
    file << "\n\n";  // for gnuplot: the next integrand
  }
}

TEST_CASE("plot irradiance two ways", "[.plot]") {
  auto file = plot_file("irradiance.tsv");
  const RectLight light;
  for (const unsigned way : {0u, 1u}) {
    const std::uint64_t block = 4096;
    const auto round = plotted_seconds([&](std::uint64_t rounds) -> std::optional<double> {
      const auto got = TRY_MEASURE(repeat_irradiance, way, block, rounds);
      if (!got) return {};
      return got->cpu_seconds;
    });
    for (std::uint64_t n = 16; n <= 65536; n *= 4) {
      const std::uint64_t replicates = n < 16384 ? 200 : 50;  // 5 % of the RMSE, and 10 %
      const auto got = way == 0
                           ? TRY_MEASURE(irradiance_area, light, n, plot_seed, replicates)
                           : TRY_MEASURE(irradiance_hemisphere, light, n, plot_seed, replicates);
      const auto* const all = got ? got->if_exactly(replicates, any_number) : nullptr;
      Row row{std::nullopt, std::nullopt};
      if (round) row[0] = *round / block * static_cast<double>(n) * 1e6;
      if (all != nullptr) {
        row[1] = rms_error(*all, irradiance(light), [](const Estimate& one) { return one.value; });
      }
      plot_row(file, row);
    }
    file << "\n\n";
  }
}

TEST_CASE("plot time against error of three sources", "[.plot]") {
  auto file = plot_file("speed.tsv");
  for (const unsigned source : {0u, 1u, 2u}) {
    const std::uint64_t block = 4096;  // 32 KB: in the first-level cache
    const auto round = plotted_seconds([&](std::uint64_t rounds) -> std::optional<double> {
      const auto got = TRY_MEASURE(repeat_source, source, block, rounds, 1);
      if (!got) return {};
      return got->cpu_seconds;
    });
    for (std::uint64_t n = 256; n <= 65536; n *= 4) {
      const std::uint64_t replicates = 200;  // 5 % of the RMSE
      const auto got = TRY_MEASURE(means_of, source, n, plot_seed, replicates);
      const auto* const means = got ? got->if_exactly(replicates, any_number) : nullptr;
      Row row{std::nullopt, std::nullopt, std::nullopt};
      if (round) {
        row[2] = *round / block * 1e9;  // ns a number
        row[0] = *row[2] * static_cast<double>(n) * 1e-3;
      }
      if (means != nullptr) row[1] = rms_error(*means, 0.5, [](double mean) { return mean; });
      plot_row(file, row);
    }
    file << "\n\n";
  }
}

}  // namespace
}  // namespace mc::checks
