// Lab 5 in the bench: figures of which there are few enough for a table, and those that the handout
// quotes.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "checks/support/catch.hpp"
#include "checks/support/exact_stratified.hpp"
#include "measurements/halton/plot_integrals.hpp"
#include "measurements/halton/plot_points.hpp"
#include "measurements/halton/tails.hpp"

namespace mc::checks {
namespace {

/// With independent decisions the N points are one in each stratum, uniform and independent there:
/// the error is a sum of N independent terms, of which variances and fourth cumulants add up.
double exact_kurtosis_of_exp(std::size_t n) {
  const auto size = static_cast<double>(n);
  double variances = 0, fourths = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double low = static_cast<double>(i) / size, high = static_cast<double>(i + 1) / size;
    // Moments about the mean by the rule of midpoints, whose error falls as 1 / steps^2.
    constexpr int steps = 200;
    const double mean = (std::exp(high) - std::exp(low)) * size;
    double second = 0, fourth = 0;
    for (int step = 0; step < steps; ++step) {
      const double d = std::exp(low + (step + 0.5) / steps / size) - mean;
      second += d * d / steps;
      fourth += d * d * d * d / steps;
    }
    variances += second;
    fourths += fourth - 3 * second * second;
  }
  return 3 + fourths / (variances * variances);
}

TEST_CASE("bench table of tails", "[.bench-table]") {
  const std::string title = "kurtosis of the error of exp(x) on the line, base 2 scrambled by 5.8";
  for (std::size_t n = 16; n <= 4096; n *= 4) {
    const std::string column = "N = " + std::to_string(n);
    bench_table({title, "independent decisions, exact", column, n, exact_kurtosis_of_exp(n)});
    const auto errors = errors_of_exp(n, 20'000);
    if (!errors) return;
    bench_table({title, "owen_scramble", column, n, errors->kurtosis(), errors->kurtosis_error()});
  }
}

/// How far D* is from the rate of a set, log N / N.
TEST_CASE("bench table of discrepancies", "[.bench-table]") {
  for (const std::size_t n : {2731u, 4096u}) {
    const auto write = [&](const char* row, const Points& points) {
      if (!points) return;
      const auto got = TRY_MEASURE(star_discrepancy_2d, (*points)[0], (*points)[1]);
      if (!got || !(got->value >= 0 && got->value <= 1)) return;
      const auto size = static_cast<double>(n);
      bench_table({"N D* / ln N in the plane", row, "N = " + std::to_string(n), n,
                   size * got->value / std::log(size)});
    };
    write("Hammersley", hammersley_points(n, 2));
    write("Sobol'", sobol_plot_points(n, {0, 1}));
  }
}

/// Of 8 x 8 cells, those without a point.
TEST_CASE("bench table of empty cells", "[.bench-table]") {
  const auto write = [](const char* row, const char* column, const Points& points) {
    if (!points) return;
    std::set<int> met;
    for (std::size_t i = 0; i < (*points)[0].size(); ++i) {
      met.insert(static_cast<int>((*points)[0][i] * 8) + 8 * static_cast<int>((*points)[1][i] * 8));
    }
    bench_table({"empty cells of 64", row, column, 0, static_cast<double>(64 - met.size())});
  };
  constexpr std::size_t n = 64;
  write("64 points in bases 29 and 31", "plain",
        joined({column_of(TRY_MEASURE(radical_inverses, 29, 0, n), n),
                column_of(TRY_MEASURE(radical_inverses, 31, 0, n), n)}));
  const Points sobol = sobol_plot_points(1024, {14, 15});
  const char* const pair = "1024 Sobol' points, dimensions 14 and 15";
  write(pair, "plain", sobol);
  write(pair, "scrambled", scrambled_sets_of(sobol, 1, 1)[0]);
}

/// Of exp(x + y) over the first n scrambled Sobol' points.
ErrorSums scrambled_errors(std::size_t n, std::size_t sets) {
  ErrorSums errors;
  const Points plain = sobol_plot_points(n, {0, 1});
  for (std::size_t done = 0; done < sets;) {
    const std::size_t some = std::min(sets - done, 1'000'000 / n);  // as a result may carry
    for (const Points& points : scrambled_sets_of(plain, some, 10'000'000 * n + done)) {
      if (!points) return {};
      errors.add(sums_over(*points, plot_integrals[1]).errors / static_cast<double>(n));
    }
    done += some;
  }
  return errors;
}

TEST_CASE("bench table of errors of scrambled points", "[.bench-table]") {
  const std::string title = "RMSE of exp(x + y) with 1024 points", column = "RMSE";
  const auto axis = strata_of([](double x) { return std::exp(x); }, 64);
  const WithinStrata cells = product_of(axis, axis);
  bench_table(
      {title, "independent, exact", column, 0, std::sqrt(independent_variance(cells, 1024))});
  bench_table({title, "the first of 4096 jittered and shuffled, exact", column, 0,
               std::sqrt(variance_of_first(cells, 1024))});
  const ErrorSums first = scrambled_errors(1024, 4000), all = scrambled_errors(4096, 2000);
  const Points sobol = sobol_plot_points(4096, {0, 1});
  if (first.count == 0 || all.count == 0 || !sobol) return;
  bench_table(
      {title, "the first of scrambled Sobol'", column, 0, first.rmse(), first.standard_error()});
  const double plain = std::abs(sums_over(*sobol, plot_integrals[1]).errors / 4096);
  bench_table({"error of exp(x + y) with 4096 Sobol' points", "plain over scrambled", "ratio", 0,
               plain / all.rmse(), plain / all.rmse() * all.standard_error() / all.rmse()});
}

}  // namespace
}  // namespace mc::checks
