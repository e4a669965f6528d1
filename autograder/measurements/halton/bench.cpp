// Lab 5 in the bench: Halton and Sobol' points, shifted and scrambled; numbers of which there are
// few enough for a table, and those that the handout quotes.

#include <cmath>
#include <set>

#include "checks/support/catch.hpp"
#include "checks/support/exact_stratified.hpp"
#include "measurements/halton/lattice_search.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

std::vector<Method> benched() {
  return {shifted(method(methods, "halton")), method(methods, "scrambled_halton"),
          shifted(method(methods, "sobol")), method(methods, "scrambled_sobol"),
          method(methods, "lattice")};
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(benched());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(benched());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  for (const Method& one : benched()) bench_growth_of_dims(one.name, one);
  // Columns of one axis, which are not cut into blocks.
  for (const auto& [name, task, of] : {std::tuple{"5.2 radical inverses, base 3", 2u, 3u},
                                       {"5.5 Sobol', dimension 1", 5u, 1u},
                                       {"5.8 the same, scrambled", 8u, 1u},
                                       {"5.9 scrambled radical inverses, base 3", 9u, 3u}}) {
    bench_growth(name, 1, 100'000'000, [task = task, of = of](Count n, Count rounds) {
      return used_by(TRY_MEASURE_WITH(large, repeat, task, of, n, rounds, 1));
    });
  }
}

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
  for (Count n = 16; n <= 4096; n *= 4) {
    const std::string column = "N = " + std::to_string(n);
    bench_table({title, "independent decisions, exact", column, n, exact_kurtosis_of_exp(n)});
    const ErrorSums errors = errors_of_exp(n, 20'000);
    if (errors.count == 0) return;
    bench_table({title, "owen_scramble", column, n, errors.kurtosis(), errors.kurtosis_error()});
  }
}

/// How far D* is from the rate of a set, log N / N.
TEST_CASE("bench table of discrepancies", "[.bench-table]") {
  for (const Count n : {2731u, 4096u}) {
    for (const auto& [row, key] : {std::pair{"Hammersley", "hammersley"}, {"Sobol'", "sobol"}}) {
      const Number found = star_discrepancy_of(method(methods, key).points(n, 2, 1, 1));
      if (!found) continue;
      const auto size = static_cast<double>(n);
      bench_table({"N D* / ln N in the plane", row, "N = " + std::to_string(n), n,
                   size * *found / std::log(size)});
    }
  }
}

/// Of 8 x 8 cells, those without a point.
TEST_CASE("bench table of empty cells", "[.bench-table]") {
  const auto write = [](const char* row, const char* column, const Sets& sets) {
    if (sets.empty()) return;
    std::set<int> met;
    for (std::size_t i = 0; i < sets[0].size(); ++i) {
      met.insert(static_cast<int>(sets[0].column(0)[i] * 8) +
                 8 * static_cast<int>(sets[0].column(1)[i] * 8));
    }
    bench_table({"empty cells of 64", row, column, 0, static_cast<double>(64 - met.size())});
  };
  write("64 points in bases 29 and 31", "plain",
        sets_by_columns(64, 2, 1, 0, [](unsigned d, const Seeds&) {
          return TRY_MEASURE(radical_inverses, d == 0 ? 29 : 31, 0, 64);
        }));
  const Sets sobol = sobol_sets(1024, {14, 15});
  const char* const pair = "1024 Sobol' points, dimensions 14 and 15";
  write(pair, "plain", sobol);
  write(pair, "scrambled", scrambled(sobol, 1, 1));
}

TEST_CASE("bench table of errors of scrambled points", "[.bench-table]") {
  const std::string title = "RMSE of exp(x + y) with 1024 points", column = "RMSE";
  const auto axis = strata_of([](double x) { return std::exp(x); }, 64);
  const WithinStrata cells = product_of(axis, axis);
  bench_table(
      {title, "independent, exact", column, 0, std::sqrt(independent_variance(cells, 1024))});
  bench_table({title, "the first of 4096 jittered and shuffled, exact", column, 0,
               std::sqrt(variance_of_first(cells, 1024))});
  const Integrand& smooth = integrand("smooth 2D");
  const Method& method_5_8 = method(methods, "scrambled_sobol");
  bench_table(title, "the first of scrambled Sobol'", column, 0,
              errors_of(method_5_8, smooth, 1024, 4000, 3));
  const ErrorSums all = errors_of(method_5_8, smooth, 4096, 2000, 2),
                  one = errors_of(method(methods, "sobol"), smooth, 4096, 1, 1);
  if (all.count == 0 || one.count == 0) return;
  const double ratio = one.rmse() / all.rmse();
  bench_table({"error of exp(x + y) with 4096 Sobol' points", "plain over scrambled", "ratio", 0,
               ratio, ratio * all.standard_error() / all.rmse()});
}

/// What the handout says of the simplest rule (5.10), where there is one; and how its numbers were
/// found.
TEST_CASE("bench table of lattices", "[.bench-table]") {
  const Method folded = method(methods, "lattice");
  Method plain = folded;
  plain.points = [](Count n, Count dims, Count count, Count seed) {
    const auto points = lattice_points(n, dims, count, seed);
    return points ? sets_of(*points, n, dims) : Sets{};
  };
  if (folded.points(2, 1, 1, 1).empty()) return;
  for (const auto& [row, one] : {std::pair{"independent", method(methods, "independent")},
                                 {"Sobol', scrambled", method(methods, "scrambled_sobol")},
                                 {"lattice, shifted", plain},
                                 {"lattice, shifted and folded", folded}}) {
    for (const char* const on : {"smooth 2D", "smooth 4D", "smooth 8D", "kinks 2D", "edge 2D"}) {
      bench_table("RMSE of 1024 points", row, on, 0, errors_of(one, integrand(on), 1024, 1000, 1));
    }
  }
  LatticeSearch search;
  for (std::size_t d = 0; d < lattice_vector.size(); ++d) {
    const auto write = [&](const char* column, double value) {
      bench_table({"lattice_vector, by the search", "z_" + std::to_string(d), column, 0, value});
    };
    write("found", static_cast<double>(search.next()));
    write("e, N = 1024", std::sqrt(search.worst_case()[8]));
    write("e, N = 65536", std::sqrt(search.worst_case().back()));
  }
}

}  // namespace
}  // namespace mc::measurements
