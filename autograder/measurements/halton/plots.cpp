// The data of lab 5's plots and demo: the points themselves, their discrepancy, pairs of axes that
// are bad for each other, errors against N and against time, error bars from replicates.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/exact_stratified.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/demo.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

const Names shown{"independent", "jittered", "halton", "hammersley", "sobol", "scrambled_sobol"};

/// The bits of a word in reverse order.
Count reversed(Count word) {
  Count all = 0;
  for (int bit = 0; bit < 64; ++bit, word >>= 1) all = all << 1 | (word & 1);
  return all;
}

/// A method that fails, to compare with: base 2 scrambled by a hash of all bits at once that is
/// right for pairs of points only, for its one multiplication by a random number is followed by one
/// mixing step.
Method hashed_points() {
  return {.key = "hashed",
          .task = "",
          .name = "a hash that is right for pairs only",
          .points = [](Count n, Count, Count count, Count seed) {
            Sets sets(count, PointSet(n, 1));
            for (PointSet& set : sets) {
              Rng rng(seed++);
              const Count shift = rng(), factor = rng() | 1;
              for (Count i = 0; i < n; ++i) {
                Count z = i;  // its radical inverse has these bits, the first one lowest
                z ^= z << 5;
                z = z * factor + shift;
                z ^= z * 0xb82f1e52d1342544u;
                set.column(0)[i] = static_cast<double>(reversed(z) >> 11) * 0x1p-53;
              }
            }
            return sets;
          }};
}

TEST_CASE("plot names", "[.plot]") {
  auto all = methods;
  all.push_back(hashed_points());
  plot_names(all);
}

TEST_CASE("plot the points", "[.plot]") {
  plot_points("points", methods_of(methods, shown), 256, 1);
  plot_points("points", {method(methods, "halton")}, 216, 1);  // 8 times 27
}

/// N at powers of two, and between them where the binary digits are 10101…: there Sobol' points are
/// as uneven as they get.
TEST_CASE("plot discrepancy against N", "[.plot]") {
  Values sizes;
  for (const double n : powers(16, 2, 4096))
    sizes.insert(sizes.end(), {std::floor(n * 2 / 3) + 1, n});
  plot_table("discrepancy.tsv", {"N", sizes}, methods_of(methods, shown),
             [](Count n, const Method& method) {
               const bool has_grid = method.key != "jittered" || (n & (n - 1)) == 0;
               return has_grid ? star_discrepancy_of(method.points(n, 2, 1, n)) : missing;
             });
}

TEST_CASE("plot the bad pairs", "[.plot]") {
  constexpr Count n = 64;
  const Sets plain = halton_sets(n, {29, 31});
  plot_points("pair-halton.tsv", plain);
  Values both;
  for (std::size_t d = 0; !plain.empty() && d < 2; ++d) {
    both.insert(both.end(), plain[0].column(d).begin(), plain[0].column(d).end());
  }
  plot_points("pair-rotated.tsv",
              both.empty() ? Sets{} : sets_of(TRY_MEASURE(random_shift, both, 2, 1, 1), n, 2, 1));
  plot_points("pair-scrambled_halton.tsv", scrambled_halton_sets(n, {29, 31}, 1, 1));
  const Sets sobol = sobol_sets(1024, 2, 14);
  plot_points("pair-sobol.tsv", sobol);
  plot_points("pair-scrambled_sobol.tsv", scrambled(sobol, 1, 1));
}

/// An RMSE of 32 sets is right to an eighth of itself: a third of a mark's height.
void plot_convergence(const Names& names, const std::vector<Integrand>& of) {
  plot_errors({.names = names,
               .integrands = of,
               .methods = methods_of(methods, shown),
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
  const auto some =
      methods_of(methods, {"independent", "rotated", "scrambled_halton", "scrambled_sobol"});
  const Axis sizes{"N", powers(4, 4, 4096)};
  plot_table("randomized-smooth.tsv", sizes, some, [](Count n, const Method& method) {
    return errors_of(method, integrand("smooth 1D"), n, 256, 1).rmse();
  });
  plot_table("randomized-wave.tsv", sizes, some, [](Count n, const Method& method) {
    const double frequency = 2 * std::numbers::pi * static_cast<double>(n);
    const Integrand wave{"wave", 1, 0, [=](View x) { return std::cos(frequency * x[0]); }};
    return errors_of(method, wave, n, 256, 1).rmse();
  });
}

/// The kurtosis: what the RMSE does not tell.
TEST_CASE("plot the tails of errors", "[.plot]") {
  auto file = plot_file("tails.tsv", {"N", "scrambled_sobol", "standard_error", "hashed", "its"});
  for (const double size : powers(16, 4, 4096)) {
    const auto n = static_cast<Count>(size);
    const Count sets = std::min<Count>(20'000, 4'000'000 / n);
    const ErrorSums errors = errors_of_exp(n, sets),
                    hashed = errors_of(hashed_points(), integrand("smooth 1D"), n, sets, 1);
    plot_row(file, {size, errors.kurtosis(), errors.kurtosis_error(), hashed.kurtosis(),
                    hashed.kurtosis_error()});
  }
}

TEST_CASE("plot error against time", "[.plot]") {
  plot_speed(methods_of(methods, {"radical_inverse", "halton", "sobol", "scrambled_sobol",
                                  "scrambled_halton"}),
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
  plot_table("early.tsv", {"N", sizes}, {"independent", "padded", "scrambled_sobol"},
             [&](double size, std::size_t c) {
               const auto n = static_cast<Count>(size);
               if (c == 0) return std::sqrt(independent_variance(cells, n));
               if (c == 1) return std::sqrt(variance_of_first(cells, n));
               return errors_of(method(methods, "scrambled_sobol"), integrand("bump"), 1024, 200,
                                99, n)
                   .rmse();
             });
}

/// The distance within which Student's t with so many degrees of freedom lies with probability
/// 0.95: the root of a quantile of F.
double t_quantile(double degrees) {
  double low = 1, high = 400;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (f_tails(middle, 1, degrees).lower < 0.95 ? low : high) = middle;
  }
  return std::sqrt(low);
}

/// What became of estimates that are means of R replicates each: the parts of the intervals by
/// Student's t and by z that hold the exact value, the mean half-length by t, and had the points
/// been independent of each other.
Values covered(const Sets& sets, std::size_t count, const Integrand& integrand) {
  if (sets.empty()) return Values(4, missing);
  const auto r = static_cast<double>(count), all = static_cast<double>(sets.size()) / r;
  const double t = t_quantile(r - 1), z = normal_quantile(0.975);
  double by_t = 0, by_z = 0, reach = 0, reach_if_independent = 0;
  for (std::size_t first = 0; first < sets.size(); first += count) {
    Values errors(count);
    for (std::size_t i = 0; i < count; ++i) errors[i] = error_of(integrand, sets[first + i]);
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / r;
    double squares = 0;
    for (const double error : errors) squares += (error - mean) * (error - mean);
    const double bar = std::sqrt(squares / (r * (r - 1)));
    const double points = r * static_cast<double>(sets[first].size());
    by_t += (std::abs(mean) <= t * bar) / all;
    by_z += (std::abs(mean) <= z * bar) / all;
    reach += t * bar / all;
    reach_if_independent += z * std::sqrt(integrand.variance / points) / all;
  }
  return {by_t, by_z, reach, reach_if_independent};
}

/// 4,096 evaluations an estimate, shared out among R replicates; 400 estimates: coverage of 95 %
/// within 1.1 %.
TEST_CASE("plot intervals from replicates", "[.plot]") {
  constexpr std::size_t evaluations = 4096, estimates = 400;
  const double z = normal_quantile(0.975);
  Names columns{"R", "z_exact"};
  for (const char* of : {"smooth", "kinks", "edge"}) {
    for (const char* what : {"t_", "z_", "reach_", "independent_"}) {
      columns.push_back(std::string(what) + of);
    }
  }
  auto file = plot_file("replicates.tsv", columns);
  for (std::size_t count = 2; count <= 64; count *= 2) {
    const Sets sets = sets_in_parts(method(methods, "scrambled_sobol"), evaluations / count, 2,
                                    estimates * count, count);
    Values row{static_cast<double>(count), f_tails(z * z, 1, static_cast<double>(count - 1)).lower};
    for (const char* name : {"smooth 2D", "kinks 2D", "edge 2D"}) {
      const Values one = covered(sets, count, integrand(name));
      row.insert(row.end(), one.begin(), one.end());
    }
    plot_row(file, row);
  }
}

/// A column, and 16 scrambled ones; to 30 bits, of which no elementary interval needs more.
template <class Scramble>
void write_columns(const std::string& key, const std::string& name, const Sets& plain,
                   unsigned number, Scramble scramble) {
  constexpr Count n = 1024, count = 16;
  if (plain.empty()) return;
  const auto first = plain[0].column(0);
  std::vector<std::string> columns{encoded(first, 5)};
  const Seeds seeds = domain::in_a_row(Count{number} << 20, count);
  for (const PointSet& one : sets_of(scramble({first.begin(), first.end()}, seeds), n, 1, count)) {
    columns.push_back(encoded(one.column(0), 5));
  }
  write_demo(5, key, {{"name", name}, {"columns", columns}});
}

/// As in lab 6: base 2 by 5.8, whose errors fall faster than those of 5.9, other bases by 5.9.
TEST_CASE("demo", "[.demo]") {
  begin_demo();
  constexpr Count n = 1024;
  const auto owen = [](const Values& column, const Seeds& seeds) {
    return TRY_MEASURE(owen_scramble, column, seeds);
  };
  for (const unsigned base : {2u, 3u, 5u, 7u, 29u, 31u}) {
    const std::string key = fmt::format("base-{}", base), name = fmt::format("base {}", base);
    if (base == 2) {
      write_columns(key, name, halton_sets(n, {base}), base, owen);
      continue;
    }
    write_columns(key, name, halton_sets(n, {base}), base, [&](const Values&, const Seeds& seeds) {
      return TRY_MEASURE(radical_inverses_scrambled, base, 0, n, seeds);
    });
  }
  write_columns("sobol", "Sobol' 1", sobol_sets(n, 1, 1), 1, owen);
}

}  // namespace
}  // namespace mc::measurements
