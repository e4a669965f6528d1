// Lab 5 in the bench: Halton and Sobol' points, shifted and scrambled; numbers of which there are
// few enough for a table, and those that the handout quotes.

#include <cmath>

#include "checks/support/catch.hpp"
#include "checks/support/exact_stratified.hpp"
#include "measurements/halton/lattice_search.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench growth", "[.bench-growth]") {
  for (const Method& one : methods) {
    if (!one.traits.dims.empty()) bench_growth_of_dims(one);
  }
  for (const auto& [name, task, base_or_dimension] :
       {std::tuple{"5.2 radical inverses, base 3", 2u, 3u},
        {"5.5 Sobol', dimension 1", 5u, 1u},
        {"5.8 the same, scrambled", 8u, 1u},
        {"5.9 scrambled radical inverses, base 3", 9u, 3u}}) {
    bench_growth({"", "", name, {}, column_by(task, base_or_dimension)}, 1, 100'000'000);
  }
}

/// With independent decisions the N points are one in each stratum, uniform and independent there:
/// the error is a sum of N independent terms, of which variances and fourth cumulants add up.
double exact_kurtosis_of_exp(Count n) {
  const auto size = static_cast<double>(n);
  const WithinStrata strata = strata_of([](double x) { return std::exp(x); }, n);
  double fourths = 0;
  for (Count i = 0; i < n; ++i) {
    const auto fourth = [&](double x) { return std::pow(std::exp(x) - strata.mean[i], 4); };
    const double low = static_cast<double>(i) / size;
    fourths +=
        size * integral(low, low + 1 / size, 1, fourth) - 3 * std::pow(strata.variance[i], 2);
  }
  return 3 + fourths / std::pow(sum_of(strata.variance), 2);
}

TEST_CASE("bench table of tails", "[.bench-table]") {
  BenchTable table{"kurtosis of the error of exp(x) on the line, base 2 scrambled by 5.8"};
  const Integrand& smooth = integrand("smooth 1D");
  for (Count n = 16; n <= 4096; n *= 4) {
    table.n = n;
    table.add("independent decisions, exact", table.column_of_n(), exact_kurtosis_of_exp(n));
    table.add_kurtosis("owen_scramble",
                       errors_of(methods["scrambled_sobol"], smooth, n, 20'000, n << 20));
  }
}

/// How far D* is from the rate of a set, log N / N.
TEST_CASE("bench table of discrepancies", "[.bench-table]") {
  BenchTable table{"N D* / ln N in the plane"};
  for (const Count n : {2731u, 4096u}) {
    table.n = n;
    for (const auto& [row, key] : {std::pair{"Hammersley", "hammersley"}, {"Sobol'", "sobol"}}) {
      const auto size = static_cast<double>(n);
      const double discrepancy = star_discrepancy_of(methods[key].points(n, 2, 1, 1));
      table.add(row, table.column_of_n(), size * discrepancy / std::log(size));
    }
  }
}

/// Of 8 x 8 cells, those without a point.
TEST_CASE("bench table of empty cells", "[.bench-table]") {
  const BenchTable table{"empty cells of 64"};
  const auto add = [&](const char* row, const char* column, const Sets& sets) {
    if (!sets.empty()) table.add(row, column, empty_cells(sets[0], 8));
  };
  add("64 points in bases 29 and 31", "plain", halton_sets(64, {29, 31}));
  const Sets sobol = sobol_sets(1024, 2, 14);
  const char* const pair = "1024 Sobol' points, dimensions 14 and 15";
  add(pair, "plain", sobol);
  add(pair, "scrambled", scrambled(sobol, 1, 1));
}

TEST_CASE("bench table of errors of scrambled points", "[.bench-table]") {
  const BenchTable table{"RMSE of exp(x + y) with 1024 points"};
  const auto axis = strata_of([](double x) { return std::exp(x); }, 64);
  const WithinStrata cells = product_of(axis, axis);
  table.add("independent, exact", "RMSE", std::sqrt(independent_variance(cells, 1024)));
  table.add("the first of 4096 jittered and shuffled, exact", "RMSE",
            std::sqrt(variance_of_first(cells, 1024)));
  const Integrand& smooth = integrand("smooth 2D");
  const Method& method_5_8 = methods["scrambled_sobol"];
  table.add_rmse("the first of scrambled Sobol'", "RMSE",
                 errors_of(method_5_8, smooth, 1024, 4000, 3));
  BenchTable{"error of exp(x + y) with 4096 Sobol' points"}.add_ratio(
      "plain over scrambled", errors_of(methods["sobol"], smooth, 4096, 1, 1).rmse(),
      errors_of(method_5_8, smooth, 4096, 2000, 2));
}

/// What the handout says of the simplest rule (5.10), where there is one; and how its numbers were
/// found.
TEST_CASE("bench table of lattices", "[.bench-table]") {
  const Method folded = methods["lattice"];
  Method plain = folded;
  plain.points = [](Count n, Count dims, Count count, Count seed) {
    return sets_of(lattice_points(n, dims, count, seed), n, dims);
  };
  if (folded.points(2, 1, 1, 1).empty()) return;
  const BenchTable errors{"RMSE of 1024 points"};
  for (const auto& [row, one] : {std::pair{"independent", methods["independent"]},
                                 {"Sobol', scrambled", methods["scrambled_sobol"]},
                                 {"lattice, shifted", plain},
                                 {"lattice, shifted and folded", folded}}) {
    for (const char* const on : {"smooth 2D", "smooth 4D", "smooth 8D", "kinks 2D", "edge 2D"}) {
      errors.add_rmse(row, on, errors_of(one, integrand(on), 1024, 1000, 1));
    }
  }
  const BenchTable found{"lattice_vector, by the search"};
  LatticeSearch search;
  for (std::size_t d = 0; d < lattice_vector.size(); ++d) {
    const std::string row = "z_" + std::to_string(d);
    found.add(row, "found", static_cast<double>(search.next()));
    found.add(row, "e, N = 1024", std::sqrt(search.worst_case()[8]));
    found.add(row, "e, N = 65536", std::sqrt(search.worst_case().back()));
  }
}

}  // namespace
}  // namespace mc::measurements
