// The data of lab 5's plots: the points themselves, their discrepancy, what integration with them
// costs in error, the bad pair of bases, and error against time.

#include <array>
#include <cmath>

#include "5-halton/experiments.hpp"
#include "checks/catch.hpp"
#include "checks/data.hpp"
#include "checks/plot_data.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;
using Column = std::optional<Values>;
using Number = std::optional<double>;

constexpr std::uint64_t replicates = 24;

/// N points of the plane; nothing where a task is missing.
struct Plane {
  Values x, y;
};
using Points = std::optional<Plane>;

Points plane(const Column& x, const Column& y) {
  if (!x || !y) return {};
  return Plane{*x, *y};
}
template <class Measured>
Column column_of(const Measured& measured) {
  if (!measured) return {};
  return measured->value;
}

Points from_columns(const Column& both) {
  if (!both) return {};
  const auto half = static_cast<std::ptrdiff_t>(both->size() / 2);
  return Plane{{both->begin(), both->begin() + half}, {both->begin() + half, both->end()}};
}

Points random_points(Rng& rng, std::size_t n) {
  Plane points{uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1)};
  return points;
}
/// One point in each cell of the squarest grid of n = 2^k cells.
Points stratified_points(Rng& rng, std::size_t n) {
  std::size_t nx = 1;
  while (nx * nx < n) nx *= 2;
  const std::size_t ny = n / nx;
  Plane points;
  for (std::size_t i = 0; i < n; ++i) {
    points.x.push_back((static_cast<double>(i % nx) + uniform(rng)) / static_cast<double>(nx));
    points.y.push_back((static_cast<double>(i / nx) + uniform(rng)) / static_cast<double>(ny));
  }
  return points;
}
Points halton_points(std::size_t n) {
  return from_columns(column_of(TRY_MEASURE(halton, n, 2, 0)));
}
Points hammersley_points(std::size_t n) {
  return from_columns(column_of(TRY_MEASURE(hammersley, n, 2)));
}
Points sobol_points(std::size_t n) {
  return plane(column_of(TRY_MEASURE(sobol, 0, 0, n)), column_of(TRY_MEASURE(sobol, 1, 0, n)));
}
Points scrambled_points(const Points& points, std::uint64_t seed) {
  if (!points) return {};
  return plane(column_of(TRY_MEASURE(owen_scramble, points->x, {2 * seed})),
               column_of(TRY_MEASURE(owen_scramble, points->y, {2 * seed + 1})));
}

void write_points(const std::string& name, const Points& points) {
  auto file = plot_file(name);
  if (!points) plot_row(file, std::array{Number{}, Number{}});
  if (points) {
    for (std::size_t i = 0; i < points->x.size(); ++i) {
      plot_row(file, std::array{Number(points->x[i]), Number(points->y[i])});
    }
  }
}

TEST_CASE("plot the points", "[.plot]") {
  Rng rng(1);
  write_points("points-1.tsv", random_points(rng, 256));
  write_points("points-2.tsv", stratified_points(rng, 256));
  write_points("points-3.tsv", halton_points(216));
  write_points("points-4.tsv", hammersley_points(256));
  write_points("points-5.tsv", sobol_points(256));
  write_points("points-6.tsv", scrambled_points(sobol_points(256), 1));
}

Number discrepancy(const Points& points) {
  if (!points) return {};
  const auto got = TRY_MEASURE(star_discrepancy_2d, points->x, points->y);
  if (!got) return {};
  return got->value;
}

TEST_CASE("plot discrepancy against N", "[.plot]") {
  auto file = plot_file("discrepancy.tsv");
  Rng rng(2);
  for (std::size_t n = 16; n <= 4096; n *= 2) {
    plot_row(file, std::array{Number(static_cast<double>(n)), discrepancy(random_points(rng, n)),
                              discrepancy(stratified_points(rng, n)), discrepancy(halton_points(n)),
                              discrepancy(hammersley_points(n)), discrepancy(sobol_points(n)),
                              discrepancy(scrambled_points(sobol_points(n), 1))});
  }
}

/// What is integrated: smooth, with a kink, with an edge; and the exact integrals.
double smooth(double x, double y) {
  return std::exp(x + y);
}
double kink(double x, double y) {
  return std::abs(x - 0.4) + std::abs(x + y - 1);
}
double edge(double x, double y) {
  return x * x + y * y < 0.7 ? 1 : 0;
}
struct Integral {
  double (*g)(double, double);
  double exact;
};
const std::array<Integral, 3> integrals{
    Integral{smooth, (std::exp(1) - 1) * (std::exp(1) - 1)},
    Integral{kink, 0.26 + 1. / 3},      // (.4^2 + .6^2)/2, and E|x + y - 1|
    Integral{edge, 0.7 * std::atan(1)}  // a quarter of a disk of radius sqrt(.7) < 1
};

Number error(const Points& points, const Integral& integral) {
  if (!points) return {};
  double sum = 0;
  for (std::size_t i = 0; i < points->x.size(); ++i) {
    sum += integral.g(points->x[i], points->y[i]) - integral.exact;
  }
  return std::abs(sum / static_cast<double>(points->x.size()));
}

/// The root of the mean square over random sets; one set where there is nothing random.
template <class Make>
void add_errors(std::array<Number, 3>& errors, std::uint64_t sets, Make make) {
  std::array<double, 3> squares{};
  for (std::uint64_t set = 0; set < sets; ++set) {
    const Points points = make(set);
    if (!points) return;
    for (std::size_t i = 0; i < 3; ++i) squares[i] += std::pow(*error(points, integrals[i]), 2);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    errors[i] = std::sqrt(squares[i] / static_cast<double>(sets));
  }
}

TEST_CASE("plot error against N", "[.plot]") {
  std::array files{plot_file("convergence-1.tsv"), plot_file("convergence-2.tsv"),
                   plot_file("convergence-3.tsv")};
  Rng rng(3);
  for (std::size_t n = 16; n <= 65536; n *= 2) {
    std::array<std::array<Number, 3>, 6> errors{};
    const Points halton = halton_points(n), hammersley = hammersley_points(n),
                 sobol = sobol_points(n);
    add_errors(errors[0], replicates, [&](auto) { return random_points(rng, n); });
    add_errors(errors[1], replicates, [&](auto) { return stratified_points(rng, n); });
    add_errors(errors[2], 1, [&](auto) { return halton; });
    add_errors(errors[3], 1, [&](auto) { return hammersley; });
    add_errors(errors[4], 1, [&](auto) { return sobol; });
    add_errors(errors[5], replicates, [&](auto set) { return scrambled_points(sobol, set); });
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<Number, 7> row{static_cast<double>(n)};
      for (std::size_t k = 0; k < 6; ++k) row[k + 1] = errors[k][i];
      plot_row(files[i], row);
    }
  }
}

TEST_CASE("plot the bad pair", "[.plot]") {
  const std::size_t n = 64;
  write_points("pair-1.tsv", plane(column_of(TRY_MEASURE(radical_inverses, 29, 0, n)),
                                   column_of(TRY_MEASURE(radical_inverses, 31, 0, n))));
  const Column x = column_of(TRY_MEASURE(radical_inverses, 29, 0, n));
  const Column y = column_of(TRY_MEASURE(radical_inverses, 31, 0, n));
  Points shifted;
  if (x && y) {
    Values both = *x;
    both.insert(both.end(), y->begin(), y->end());
    shifted = from_columns(column_of(TRY_MEASURE(random_shift, both, 2, 1, 1)));
  }
  write_points("pair-2.tsv", shifted);
  write_points("pair-3.tsv",
               plane(column_of(TRY_MEASURE(radical_inverses_scrambled, 29, 0, n, {1})),
                     column_of(TRY_MEASURE(radical_inverses_scrambled, 31, 0, n, {2}))));
}

/// Nanoseconds a value of task 5.`task` along one axis, in columns of 4096.
Number nanoseconds(unsigned task, unsigned of) {
  constexpr std::uint64_t n = 4096;
  const auto round = seconds_a_round([&](std::uint64_t rounds) -> Number {
    const auto got = TRY_MEASURE(repeat, task, of, n, rounds);
    if (!got) return {};
    return got->cpu_seconds;
  });
  if (!round) return {};
  return *round * 1e9 / n;
}

/// Time for a point of the plane, and the error of the smooth integral with 4096 of them.
TEST_CASE("plot error against time", "[.plot]") {
  auto file = plot_file("speed.tsv");
  const std::size_t n = 4096;
  std::array<Number, 3> scrambled_halton{}, scrambled_sobol{};
  const Points halton = halton_points(n), sobol = sobol_points(n);
  add_errors(scrambled_sobol, replicates,
             [&](auto set) { return scrambled_points(sobol, set + 100); });
  add_errors(scrambled_halton, replicates, [&](std::uint64_t set) {
    return plane(column_of(TRY_MEASURE(radical_inverses_scrambled, 2, 0, n, {2 * set})),
                 column_of(TRY_MEASURE(radical_inverses_scrambled, 3, 0, n, {2 * set + 1})));
  });
  const auto both = [](Number x, Number y) { return x && y ? Number(*x + *y) : Number{}; };
  const Number error_halton = error(halton, integrals[0]);
  plot_row(file, std::array{Number(1), both(nanoseconds(1, 2), nanoseconds(1, 3)), error_halton});
  plot_row(file, std::array{Number(2), both(nanoseconds(2, 2), nanoseconds(2, 3)), error_halton});
  plot_row(file, std::array{Number(5), both(nanoseconds(5, 0), nanoseconds(5, 1)),
                            error(sobol, integrals[0])});
  plot_row(file,
           std::array{Number(8), both(nanoseconds(8, 0), nanoseconds(8, 1)), scrambled_sobol[0]});
  plot_row(file,
           std::array{Number(9), both(nanoseconds(9, 2), nanoseconds(9, 3)), scrambled_halton[0]});
}

}  // namespace
}  // namespace mc::checks
