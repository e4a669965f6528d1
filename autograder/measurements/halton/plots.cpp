// The data of lab 5's plots: the points themselves, their discrepancy, pairs of axes that are bad
// for each other, errors against N and against time.

#include <cmath>
#include <numbers>

#include "checks/support/catch.hpp"
#include "checks/support/exact_stratified.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/halton/tails.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

const Names shown{"independent", "jittered", "halton", "hammersley", "sobol", "scrambled_sobol"};

TEST_CASE("plot names", "[.plot]") {
  auto all = methods;
  all.push_back(hashed_points());
  plot_names(all);
}

TEST_CASE("plot the points", "[.plot]") {
  for (const std::string& key : shown) {
    plot_points("points-" + key + ".tsv",
                method(methods, key).points(key == "halton" ? 216 : 256, 2, 1, 1));
  }
}

/// N at powers of two, and between them where the binary digits are 10101…: there Sobol' points are
/// as uneven as they get.
TEST_CASE("plot discrepancy against N", "[.plot]") {
  std::vector<double> sizes;
  for (const double n : powers(16, 2, 4096))
    sizes.insert(sizes.end(), {std::floor(n * 2 / 3) + 1, n});
  plot_table("discrepancy.tsv", "N", sizes, shown, [](double size, std::size_t c) -> Number {
    const auto n = static_cast<Count>(size);
    if (shown[c] == "jittered" && (n & (n - 1)) != 0) return {};  // there is no such grid
    return star_discrepancy_of(method(methods, shown[c]).points(n, 2, 1, n));
  });
}

TEST_CASE("plot the bad pairs", "[.plot]") {
  constexpr Count n = 64;
  constexpr unsigned bases[] = {29, 31};
  const Sets plain = sets_by_columns(n, 2, 1, 0, [&](unsigned d, const Seeds&) {
    return TRY_MEASURE(radical_inverses, bases[d], 0, n);
  });
  plot_points("pair-halton.tsv", plain);
  std::vector<double> both;
  for (std::size_t d = 0; !plain.empty() && d < 2; ++d) {
    both.insert(both.end(), plain[0].column(d).begin(), plain[0].column(d).end());
  }
  plot_points("pair-rotated.tsv",
              both.empty() ? Sets{} : sets_of(TRY_MEASURE(random_shift, both, 2, 1, 1), n, 2, 1));
  plot_points("pair-scrambled_halton.tsv",
              sets_by_columns(n, 2, 1, 1, [&](unsigned d, const Seeds& seeds) {
                return TRY_MEASURE(radical_inverses_scrambled, bases[d], 0, n, seeds);
              }));
  const Sets sobol = sobol_sets(1024, {14, 15});
  plot_points("pair-sobol.tsv", sobol);
  plot_points("pair-scrambled_sobol.tsv", scrambled(sobol, 1, 1));
}

/// An RMSE of 32 sets is right to an eighth of itself: a third of a mark's height.
void plot_convergence(const Names& names, const std::vector<Integrand>& of) {
  auto keys = shown;
  keys.push_back("lattice");
  plot_errors({.names = names,
               .integrands = of,
               .methods = methods_of(methods, keys),
               .sizes = {16, 64, 256, 1024, 4096, 16384, 65536},
               .replicates = [](Count n) -> Count { return n > 10000 ? 8 : 32; }});
}
TEST_CASE("plot error against N on the line", "[.plot]") {
  plot_convergence({"line"}, {integrand("smooth 1D")});
}
TEST_CASE("plot error against N in the plane", "[.plot]") {
  plot_convergence({"plane", "kinks", "edge"},
                   {integrand("smooth 2D"), integrand("kinks 2D"), integrand("edge 2D")});
}
TEST_CASE("plot error against N in four dimensions", "[.plot]") {
  plot_convergence({"four"}, {integrand("smooth 4D")});
}

/// The same column of base 2, randomized in every way of this lab; for exp(x), and for a wave of
/// frequency N.
TEST_CASE("plot error of randomized points", "[.plot]") {
  const Names keys{"independent", "rotated", "scrambled_halton", "scrambled_sobol"};
  for (const bool is_wave : {false, true}) {
    plot_table(is_wave ? "randomised-wave.tsv" : "randomised-smooth.tsv", "N", powers(4, 4, 4096),
               keys, [&](double n, std::size_t c) {
                 const double frequency = 2 * std::numbers::pi * n;
                 const Integrand wave{"wave", "cos(2 pi N x)", 1, 0,
                                      [=](auto x) { return std::cos(frequency * x[0]); }};
                 return rmse_of(errors_of(method(methods, keys[c]),
                                          is_wave ? wave : integrand("smooth 1D"),
                                          static_cast<Count>(n), 256, 1));
               });
  }
}

/// The kurtosis: what the RMSE does not tell.
TEST_CASE("plot the tails of errors", "[.plot]") {
  ErrorSums errors;
  plot_table("tails.tsv", "N", powers(16, 4, 4096),
             {"scrambled_sobol", "standard_error", "hashed", "its"},
             [&](double size, std::size_t c) -> Number {
               const auto n = static_cast<Count>(size);
               const Count sets = std::min<Count>(20'000, 4'000'000 / n);
               if (c == 0) errors = errors_of_exp(n, sets);
               if (c == 2) errors = errors_of(hashed_points(), integrand("smooth 1D"), n, sets, 1);
               if (errors.count == 0) return {};
               return c % 2 == 0 ? errors.kurtosis() : errors.kurtosis_error();
             });
}

TEST_CASE("plot error against time", "[.plot]") {
  plot_speed(methods_of(methods, {"radical_inverse", "halton", "sobol", "scrambled_sobol",
                                  "scrambled_halton"}),
             integrand("smooth 2D"), 4096, 32);
}

/// The first n of 1,024 points, as lab 3 draws it: independent and
/// shuffled jittered points exactly, scrambled Sobol' points as the RMSE of 200 sets. Powers of
/// two, and three sizes between them.
TEST_CASE("plot the first points of a sequence", "[.plot]") {
  const auto axis = strata_of([](double x) { return std::exp(-x * x); }, 32);
  const WithinStrata cells = product_of(axis, axis);
  std::vector<double> sizes;
  for (const double n : powers(1, std::exp2(0.25), 1025)) {
    if (sizes.empty() || std::round(n) > sizes.back()) sizes.push_back(std::round(n));
  }
  plot_table("early.tsv", "N", sizes, {"independent", "padded", "scrambled_sobol"},
             [&](double size, std::size_t c) -> Number {
               const auto n = static_cast<Count>(size);
               if (c == 0) return std::sqrt(independent_variance(cells, n));
               if (c == 1) return std::sqrt(variance_of_first(cells, n));
               return rmse_of(errors_of(method(methods, "scrambled_sobol"), integrand("bump"), 1024,
                                        200, 99, n));
             });
}

}  // namespace
}  // namespace mc::measurements
