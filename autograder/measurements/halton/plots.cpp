// The data of lab 5's plots and demo: the points themselves, their discrepancy, pairs of axes that
// are bad for each other, errors against N and against time, error bars from replicates.

#include <cmath>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/exact_stratified.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

const Names shown{"independent", "jittered", "halton", "hammersley", "sobol", "scrambled_sobol"};

TEST_CASE("plot the points", "[.plot]") {
  plot_points("points", methods.of(shown), 256, 1);
  plot_points("points", methods.of({"halton"}), 216, 1);  // 8 times 27
}

/// N at powers of two, and between them where the binary digits are 10101…: there Sobol' points are
/// as uneven as they get.
TEST_CASE("plot discrepancy against N", "[.plot]") {
  Values sizes;
  for (const double n : powers(16, 2, 4096)) append(sizes, Values{std::floor(n * 2 / 3) + 1, n});
  plot_table("discrepancy.tsv", {"N", sizes}, methods.of(shown), [](Count n, const Method& method) {
    const bool has_grid = method.key != "jittered" || (n & (n - 1)) == 0;
    return has_grid ? star_discrepancy_of(method.points(n, 2, 1, n)) : missing;
  });
}

TEST_CASE("plot the bad pairs", "[.plot]") {
  constexpr Count n = 64;
  const Sets plain = halton_sets(n, {29, 31});
  plot_points("pair-halton.tsv", plain);
  plot_points("pair-rotated.tsv", rotated(plain, 1, 1));
  plot_points("pair-scrambled_halton.tsv", scrambled_halton_sets(n, {29, 31}, 1, 1));
  const Sets sobol = sobol_sets(1024, 2, 14);
  plot_points("pair-sobol.tsv", sobol);
  plot_points("pair-scrambled_sobol.tsv", scrambled(sobol, 1, 1));
}

/// An RMSE of 32 sets is right to an eighth of itself: a third of a mark's height.
void plot_convergence(const Names& names, const std::vector<Integrand>& of) {
  plot_errors(names, of, methods.of(shown), powers(16, 4, 65536),
              [](Count) -> Count { return 32; });
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

/// The kurtosis: what the RMSE does not tell.
TEST_CASE("plot the tails of errors", "[.plot]") {
  auto file = plot_file("tails.tsv", {"N", "scrambled_sobol", "standard_error", "hashed", "its"});
  for (const double size : powers(16, 4, 4096)) {
    const auto n = static_cast<Count>(size);
    const Count sets = std::min<Count>(20'000, 4'000'000 / n);
    const Integrand& smooth = integrand("smooth 1D");
    const ErrorSums errors = errors_of(methods["scrambled_sobol"], smooth, n, sets, n << 20),
                    hashed = errors_of(methods["hashed"], smooth, n, sets, 1);
    plot_row(file, {size, errors.kurtosis(), errors.kurtosis_error(), hashed.kurtosis(),
                    hashed.kurtosis_error()});
  }
}

TEST_CASE("plot error against time", "[.plot][time]") {
  plot_speed(
      methods.of({"radical_inverse", "halton", "sobol", "scrambled_sobol", "scrambled_halton"}),
      integrand("smooth 2D"), 4096, 32);
}

/// The first n of 1,024 points, as lab 3 draws it: independent and shuffled jittered points
/// exactly, scrambled Sobol' points as the RMSE of 200 sets. Powers of two, and three sizes between
/// them.
TEST_CASE("plot the first points of a sequence", "[.plot]") {
  const auto axis = strata_of([](double x) { return std::exp(-x * x); }, 32);
  const WithinStrata cells = product_of(axis, axis);
  std::vector<double> sizes;
  for (const double n : powers(1, std::exp2(0.25), 1025)) {
    if (sizes.empty() || std::round(n) > sizes.back()) sizes.push_back(std::round(n));
  }
  plot_table(
      "early.tsv", {"N", sizes}, {"independent", "padded", "scrambled_sobol"},
      [&](double size, std::size_t c) {
        const auto n = static_cast<Count>(size);
        if (c == 0) return std::sqrt(independent_variance(cells, n));
        if (c == 1) return std::sqrt(variance_of_first(cells, n));
        return errors_of(methods["scrambled_sobol"], integrand("bump"), 1024, 200, 99, n).rmse();
      });
}

/// What became of estimates that are means of R replicates each: the parts of the intervals by
/// Student's t and by z that hold the exact value, the mean half-length by t, and had the points
/// been independent of each other.
Values covered(const Sets& sets, std::size_t count, const Integrand& integrand) {
  if (sets.empty()) return Values(4, missing);
  const auto r = static_cast<double>(count), all = static_cast<double>(sets.size()) / r;
  // The distance within which t lies with probability 0.95: the root of a quantile of F.
  const auto tails = [=](double x) { return f_tails(x, 1, r - 1); };
  const double t = std::sqrt(central_interval(tails, 0.1, 1, 400).high);
  const double z = normal_quantile(0.975);
  Values result(4);
  for (std::size_t first = 0; first < sets.size(); first += count) {
    const std::size_t n = sets[first].size();
    Values errors;
    for (std::size_t i = 0; i < count; ++i) {
      errors.push_back(error_of(integrand, sets[first + i], n));
    }
    const double mean = sum_of(errors) / r, points = r * static_cast<double>(n);
    const double bar = std::sqrt(squared_deviations(errors) / (r * (r - 1)));
    result[0] += (std::abs(mean) <= t * bar) / all;
    result[1] += (std::abs(mean) <= z * bar) / all;
    result[2] += t * bar / all;
    result[3] += z * std::sqrt(integrand.variance / points) / all;
  }
  return result;
}

/// 4,096 evaluations an estimate, shared out among R replicates; 400 estimates: coverage of 95 %
/// within 1.1 %.
TEST_CASE("plot intervals from replicates", "[.plot]") {
  constexpr std::size_t evaluations = 4096, estimates = 400;
  Names columns{"R", "z_exact"};
  for (const char* of : {"smooth", "kinks", "edge"}) {
    for (const char* what : {"t_", "z_", "reach_", "independent_"}) {
      columns.push_back(std::string(what) + of);
    }
  }
  auto file = plot_file("replicates.tsv", columns);
  for (std::size_t count = 2; count <= 64; count *= 2) {
    const auto r = static_cast<double>(count);
    const Sets sets =
        sets_in_parts(methods["scrambled_sobol"], evaluations / count, 2, estimates * count, count);
    Values row{r, f_tails(std::pow(normal_quantile(0.975), 2), 1, r - 1).lower};
    for (const char* name : {"smooth 2D", "kinks 2D", "edge 2D"}) {
      append(row, covered(sets, count, integrand(name)));
    }
    plot_row(file, row);
  }
}

/// A column, and scrambled ones.
struct DemoColumns {
  std::string key, name;
  Sets plain, scrambled;
};

/// To 30 bits, of which no elementary interval needs more.
void write_columns(const DemoColumns& some) {
  if (some.plain.empty()) return;
  std::vector<std::string> columns{encoded(some.plain[0].column(0), 5)};
  for (const PointSet& one : some.scrambled) columns.push_back(encoded(one.column(0), 5));
  write_demo(5, some.key, {{"name", some.name}, {"columns", columns}});
}

/// As in lab 6: base 2 by 5.8, whose errors fall faster than those of 5.9, other bases by 5.9.
TEST_CASE("demo", "[.demo]") {
  begin_demo();
  constexpr Count n = 1024, count = 16;
  for (const unsigned base : {2u, 3u, 5u, 7u, 29u, 31u}) {
    const Sets plain = halton_sets(n, {base});
    write_columns({.key = fmt::format("base-{}", base),
                   .name = fmt::format("base {}", base),
                   .plain = plain,
                   .scrambled = base == 2 ? scrambled(plain, count, base)
                                          : scrambled_halton_sets(n, {base}, count, base)});
  }
  const Sets sobol = sobol_sets(n, 1, 1);
  write_columns({"sobol", "Sobol' 1", sobol, scrambled(sobol, count, 1)});
}

}  // namespace
}  // namespace mc::measurements
