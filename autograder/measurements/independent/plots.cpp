// The data of lab 2's plots. The same seeds for every submission, so that their lines can be
// compared.

#include <cmath>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/independent/methods.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

constexpr Count plot_seed = 1;

/// Columns of those integrands of the table, counted from 1.
Names columns_of(const std::vector<std::size_t>& which) {
  Names all;
  for (const std::size_t i : which) all.push_back("integrand_" + std::to_string(i));
  return all;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

TEST_CASE("plot error against samples", "[.plot]") {
  const Names columns = columns_of({1, 2, 3, 4, 5});
  plot_table(
      "error.tsv", {"N", powers(4, 4, 65536)}, columns, [](double n, std::size_t c) -> Number {
        // Two of three medians of 201 errors are off by 8 % at most, of 101 by 12 %: 4 pixels.
        const Count replicates = n <= 4096 ? 201 : 101;
        // Medians: where the variance is infinite, a mean square says how long one waited.
        const auto& [name, g, mean] = line_integrands[c];
        const auto all = lists_of(
            TRY_MEASURE(estimates, g, static_cast<Count>(n), plot_seed, replicates), replicates);
        if (!all) return {};
        std::vector<double> errors;
        for (const auto& one : *all) errors.push_back(std::abs(one.value / mean - 1));
        return median(errors);
      });
}

TEST_CASE("plot coverage against samples", "[.plot]") {
  constexpr std::size_t which[] = {6, 3, 4, 5};
  Names columns = columns_of({6, 3, 4, 5});
  columns.push_back("exact");
  const Count replicates = 500;  // a standard error of 1 % at 95 %
  const double level = 0.95, z = normal_quantile((1 + level) / 2);
  plot_table("coverage.tsv", {"N", powers(2, 2, 8192)}, columns,
             [&](double n, std::size_t c) -> Number {
               // Of normal values it is known: Student's t within z.
               if (c == 4) return f_tails(z * z, 1, n - 1).lower;
               const auto& [name, g, mean] = line_integrands[which[c] - 1];
               const auto all = lists_of(TRY_MEASURE(confidence_intervals, g, static_cast<Count>(n),
                                                     level, plot_seed, replicates),
                                         replicates, any_number);
               if (!all) return {};
               double covering = 0;
               for (const Interval& one : *all) covering += one.low <= mean && mean <= one.high;
               return covering / static_cast<double>(replicates);
             });
}

TEST_CASE("plot intervals of sixty estimates", "[.plot]") {
  const double z = normal_quantile(0.975);
  for (const auto& [file_name, i] :
       {std::pair{"intervals-exp.tsv", 0}, {"intervals-power.tsv", 4}}) {
    const auto& [name, g, mean] = line_integrands[static_cast<std::size_t>(i)];
    auto file = plot_file(file_name, {"rank", "value", "reach", "covers"});
    auto all = lists_of(TRY_MEASURE(estimates, g, 1000, plot_seed, 60), 60)
                   .value_or(std::vector<experiments::CountedEstimate>(1, {NAN, NAN, 0, 0}));
    std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.value < b.value; });
    double rank = 0;
    for (const auto& one : all) {
      const double reach = z * one.standard_error;
      const double covers = std::abs(one.value - mean) <= reach ? 1 : 0;
      plot_row(file, Row{++rank, one.value / mean, reach / mean, covers});
    }
  }
}

/// Rows of n values or samples: microseconds of all of them, an RMSE, nanoseconds of one.
void plot_against_time(const std::string& name, Count least, const Rounds& rounds_of_4096,
                       const std::function<ErrorSums(Count)>& errors) {
  auto file = plot_file(name, {"us", "error", "ns"});
  // For an axis of time, noise of a few per cent is nothing.
  const Number round = seconds_of(rounds_of_4096, 0.008, 3);
  for (Count n = least; n <= 65536; n *= 4) {
    Row row{{}, rmse_of(errors(n)), {}};
    if (round) {
      row[2] = *round / 4096 * 1e9;
      row[0] = *row[2] * static_cast<double>(n) * 1e-3;
    }
    plot_row(file, row);
  }
}

TEST_CASE("plot irradiance two ways", "[.plot]") {
  for (const unsigned way : {0u, 1u}) {
    plot_against_time(
        way == 0 ? "irradiance-area.tsv" : "irradiance-hemisphere.tsv", 16,
        [&](Count rounds) {
          return cpu_seconds_of(TRY_MEASURE(repeat_irradiance, way, 4096, rounds));
        },
        [&](Count n) {  // 5 % of the RMSE, and 10 %
          return irradiance_errors(way, n, n < 16384 ? 200 : 50, plot_seed);
        });
  }
}

/// 0 std::mt19937_64 and std::uniform_real_distribution, 1 to_unit(rng()), 2 uniforms(); in blocks
/// of 32 KB, in the first-level cache.
TEST_CASE("plot time against error of three sources", "[.plot]") {
  for (const unsigned source : {0u, 1u, 2u}) {
    plot_against_time(
        "speed-" + std::to_string(source) + ".tsv", 256,
        [&](Count rounds) {
          return cpu_seconds_of(TRY_MEASURE(repeat_source, source, 4096, rounds, 1));
        },
        [&](Count n) {
          const auto means =
              lists_of(TRY_MEASURE(means_of, source, n, plot_seed, 200), 200, any_number);
          ErrorSums errors;
          for (const double mean : means.value_or(std::vector<double>())) errors.add(mean - 0.5);
          return errors;
        });
  }
}

}  // namespace
}  // namespace mc::measurements
