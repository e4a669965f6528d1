// The data of lab 2's plots and demo. The same seeds for every submission, so that their lines can
// be compared.

#include <cmath>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/independent/methods.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

/// Columns are integrands of the table, counted from 1.
TEST_CASE("plot error against samples", "[.plot]") {
  plot_table("error.tsv", {"N", powers(4, 4, 65536)},
             {"integrand_1", "integrand_2", "integrand_3", "integrand_4", "integrand_5"},
             [](double n, std::size_t c) {
               // Two of three medians of 201 errors are off by 8 % at most, of 101 by 12 %: 4
               // pixels. Medians: where the variance is infinite, a mean square says how long one
               // waited.
               const Count replicates = n <= 4096 ? 201 : 101;
               const LineIntegrand& integrand = line_integrands[c];
               Values errors;
               for (const auto& one : estimates_of(integrand, static_cast<Count>(n), replicates)) {
                 errors.push_back(std::abs(one.value / integrand.mean - 1));
               }
               return errors.empty() ? missing : median(errors);
             });
}

TEST_CASE("plot coverage against samples", "[.plot]") {
  constexpr std::size_t shown[] = {6, 3, 4, 5};
  const Count replicates = 500;  // a standard error of 1 % at 95 %
  const double level = 0.95, z = normal_quantile((1 + level) / 2);
  plot_table("coverage.tsv", {"N", powers(2, 2, 8192)},
             {"integrand_6", "integrand_3", "integrand_4", "integrand_5", "exact"},
             [&](double n, std::size_t c) {
               // Of normal values it is known: Student's t within z.
               if (c == 4) return f_tails(z * z, 1, n - 1).lower;
               const auto& [name, g, mean] = line_integrands[shown[c] - 1];
               const auto all = values_of(TRY_MEASURE(confidence_intervals, g,
                                                      static_cast<Count>(n), level, 1, replicates),
                                          replicates, any_number);
               double covering = 0;
               for (const Interval& one : all) covering += one.low <= mean && mean <= one.high;
               return all.empty() ? missing : covering / static_cast<double>(replicates);
             });
}

TEST_CASE("plot intervals of sixty estimates", "[.plot]") {
  const double z = normal_quantile(0.975);
  for (const auto& [file_name, integrand] : {std::pair{"intervals-exp.tsv", line_integrands[0]},
                                             {"intervals-power.tsv", line_integrands[4]}}) {
    auto file = plot_file(file_name, {"rank", "value", "reach", "covers"});
    auto all = estimates_of(integrand, 1000, 60);
    if (all.empty()) all.push_back({missing, missing});  // a row to draw in any case
    std::sort(all.begin(), all.end(), [](auto& a, auto& b) { return a.value < b.value; });
    double rank = 0;
    for (const auto& one : all) {
      const double reach = z * one.standard_error;
      const double covers = std::abs(one.value - integrand.mean) <= reach ? 1 : 0;
      plot_row(file, {++rank, one.value / integrand.mean, reach / integrand.mean, covers});
    }
  }
}

/// Rows of n values or samples: microseconds of all of them, an RMSE, nanoseconds of one.
void plot_against_time(const std::string& name, Count least, const Rounds& rounds_of_4096,
                       const std::function<ErrorSums(Count)>& errors) {
  auto file = plot_file(name, {"us", "error", "ns"});
  // For an axis of time, noise of a few per cent is nothing.
  const double one = seconds_of(rounds_of_4096, 0.008, 3) / 4096 * 1e9;
  for (Count n = least; n <= 65536; n *= 4) {
    plot_row(file, {one * static_cast<double>(n) * 1e-3, errors(n).rmse(), one});
  }
}

TEST_CASE("plot irradiance three ways", "[.plot][time]") {
  for (const LightWay& way : light_ways) {
    plot_against_time(fmt::format("irradiance-{}.tsv", way.key), 16, way.rounds(), [&](Count n) {
      return way.errors(n, n < 16384 ? 200 : 50, 1);  // 5 % of the RMSE, and 10 %
    });
  }
}

/// 0 std::mt19937_64 and std::uniform_real_distribution, 1 to_unit(rng()), 2 uniforms(); in blocks
/// of 32 KB, in the first-level cache.
TEST_CASE("plot time against error of three sources", "[.plot][time]") {
  for (const unsigned source : {0u, 1u, 2u}) {
    plot_against_time(
        fmt::format("speed-{}.tsv", source), 256,
        [&](Count rounds) { return TRY_MEASURE(repeat_source, source, 4096, rounds, 1); },
        [&](Count n) {
          ErrorSums errors;
          const auto got = TRY_MEASURE(means_of, source, n, 1, 200);
          for (const double mean : values_of(got, 200, any_number)) errors.add(mean - 0.5);
          return errors;
        });
  }
}

double rounded(double value) {
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

/// A hundred estimates with their standard errors at every N.
TEST_CASE("demo of intervals", "[.demo]") {
  begin_demo();
  const Values levels{0.5, 0.683, 0.8, 0.9, 0.95, 0.99, 0.999};
  Values z;
  for (const double level : levels) z.push_back(normal_quantile((1 + level) / 2));
  for (const std::size_t i : {0u, 2u, 3u, 4u}) {
    Values sizes, values, errors;
    for (Count n = 4; n <= 16384; n *= 4) {
      const auto all = estimates_of(line_integrands[i], n, 100);
      if (all.empty()) return;
      sizes.push_back(static_cast<double>(n));
      for (const auto& one : all) {
        values.push_back(rounded(one.value));
        errors.push_back(rounded(one.standard_error));
      }
    }
    write_demo(2, fmt::format("intervals-{}", i),
               {{"name", std::string(line_integrands[i].name)},
                {"mean", line_integrands[i].mean},
                {"levels", levels},
                {"z", z},
                {"sizes", sizes},
                {"values", values},
                {"errors", errors}});
  }
}

TEST_CASE("demo of points", "[.demo]") {
  demo_points(2, methods);
}

}  // namespace
}  // namespace mc::measurements
