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
  auto all = methods();
  all.push_back(hashed_points());
  plot_names(all);
}

TEST_CASE("plot the points", "[.plot]") {
  for (const std::string& key : shown) {
    plot_points("points-" + key + ".tsv",
                method(methods(), key).points(key == "halton" ? 216 : 256, 2, 1, 1));
  }
}

/// N at powers of two, and between them where the binary digits are 10101…: there Sobol' points are
/// as uneven as they get.
TEST_CASE("plot discrepancy against N", "[.plot]") {
  Names columns = shown;
  columns.insert(columns.begin(), "N");
  auto file = plot_file("discrepancy.tsv", columns);
  for (Count power = 16; power <= 4096; power *= 2) {
    for (const Count n : {power * 2 / 3 + 1, power}) {
      Row row{static_cast<double>(n)};
      for (const Method& one : methods_of(methods(), shown)) {
        row.emplace_back();
        if (one.key == "jittered" && n != power) continue;  // there is no such grid
        const Sets sets = one.points(n, 2, 1, n);
        if (sets.empty()) continue;
        const auto x = sets[0].column(0), y = sets[0].column(1);
        const auto got =
            TRY_MEASURE(star_discrepancy_2d, {x.begin(), x.end()}, {y.begin(), y.end()});
        if (got && got->value >= 0 && got->value <= 1) row.back() = got->value;
      }
      plot_row(file, row);
    }
  }
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
  plot_errors({.names = names,
               .integrands = of,
               .methods = methods_of(methods(), shown),
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
  Names columns = keys;
  columns.insert(columns.begin(), "N");
  auto smooth = plot_file("randomised-smooth.tsv", columns),
       waves = plot_file("randomised-wave.tsv", columns);
  for (Count n = 4; n <= 4096; n *= 4) {
    const double frequency = 2 * std::numbers::pi * static_cast<double>(n);
    const Integrand wave{
        .name = "wave",
        .formula = "cos(2 pi N x)",
        .dims = 1,
        .mean = 0,
        .g = [=](std::span<const double> x) { return std::cos(frequency * x[0]); }};
    std::vector<Row> rows(2, Row{static_cast<double>(n)});
    for (const Method& one : methods_of(methods(), keys)) {
      const auto errors = errors_of(one, {integrand("smooth 1D"), wave}, n, 256, 1);
      for (std::size_t i = 0; i < 2; ++i) rows[i].push_back(rmse_of(errors[i]));
    }
    plot_row(smooth, rows[0]);
    plot_row(waves, rows[1]);
  }
}

/// The kurtosis: what the RMSE does not tell.
TEST_CASE("plot the tails of errors", "[.plot]") {
  auto file = plot_file("tails.tsv", {"N", "scrambled_sobol", "standard_error", "hashed", "its"});
  for (Count n = 16; n <= 4096; n *= 4) {
    const Count sets = std::min<Count>(20'000, 4'000'000 / n);
    Row row{static_cast<double>(n)};
    for (const ErrorSums& errors :
         {errors_of_exp(n, sets), errors_of(hashed_points(), integrand("smooth 1D"), n, sets, 1)}) {
      const bool is_there = errors.count > 0;
      row.push_back(is_there ? Number(errors.kurtosis()) : Number{});
      row.push_back(is_there ? Number(errors.kurtosis_error()) : Number{});
    }
    plot_row(file, row);
  }
}

TEST_CASE("plot error against time", "[.plot]") {
  plot_speed(methods_of(methods(), {"radical_inverse", "halton", "sobol", "scrambled_sobol",
                                    "scrambled_halton"}),
             integrand("smooth 2D"), 4096, 32);
}

/// The first n of 1,024 points that somebody stops early, as lab 3 draws it: independent and
/// shuffled jittered points exactly, scrambled Sobol' points as the RMSE of 200 sets. Powers of
/// two, and three sizes between them.
TEST_CASE("plot the first points of a sequence", "[.plot]") {
  const auto axis = strata_of([](double x) { return std::exp(-x * x); }, 32);
  const WithinStrata cells = product_of(axis, axis);
  auto file = plot_file("early.tsv", {"N", "independent", "padded", "scrambled_sobol"});
  for (Count quarter = 0, done = 0; quarter <= 40; ++quarter) {
    const auto n = static_cast<Count>(std::lround(std::exp2(static_cast<double>(quarter) / 4)));
    if (n == done) continue;
    done = n;
    const ErrorSums errors =
        errors_of(method(methods(), "scrambled_sobol"), integrand("bump"), 1024, 200, 99, n);
    plot_row(file, Row{static_cast<double>(n), std::sqrt(independent_variance(cells, n)),
                       std::sqrt(variance_of_first(cells, n)), rmse_of(errors)});
  }
}

}  // namespace
}  // namespace mc::measurements
