// The data of lab 5's plots: the points themselves, their discrepancy, what integration with them
// costs in error, the bad pair of bases, and error against time.

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "5-halton/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/plot_data.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;
using Column = std::optional<Values>;
using Number = std::optional<double>;

constexpr std::uint64_t replicates = 24;

/// Points by their columns; nothing where a task is missing.
using Points = std::optional<std::vector<Values>>;

template <class Measured>
Column column_of(const Measured& measured) {
  if (!measured) return {};
  return measured->value;
}

Points joined(const std::vector<Column>& columns) {
  std::vector<Values> points;
  for (const Column& column : columns) {
    if (!column) return {};
    points.push_back(*column);
  }
  return points;
}

/// A list of `dims` columns, one after the other, taken apart.
Points from_columns(const Column& all, std::size_t dims) {
  if (!all) return {};
  std::vector<Values> points;
  const auto n = static_cast<std::ptrdiff_t>(all->size() / dims);
  for (auto at = all->begin(); points.size() < dims; at += n) points.emplace_back(at, at + n);
  return points;
}

Points random_points(Rng& rng, std::size_t n, std::size_t dims = 2) {
  std::vector<Values> points;
  while (points.size() < dims) points.push_back(uniform_values(rng, n, 0, 1));
  return points;
}
/// One point in each stratum of the line, in each cell of the squarest grid of n = 2^k cells in the
/// plane; in four dimensions two such grids side by side, each in an order of its own.
Points stratified_points(Rng& rng, std::size_t n, std::size_t dims = 2) {
  std::size_t nx = 1;
  while (nx * nx < n) nx *= 2;
  if (dims == 1) nx = n;
  const std::size_t ny = n / nx;
  std::vector<Values> points(dims, Values(n));
  std::vector<std::size_t> order(n);
  for (std::size_t d = 0; d < dims; d += 2) {
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (dims > 2) std::shuffle(order.begin(), order.end(), rng);
    for (std::size_t i = 0; i < n; ++i) {
      const auto along = [&](std::size_t cell, std::size_t cells) {
        return (static_cast<double>(cell) + uniform(rng)) / static_cast<double>(cells);
      };
      points[d][i] = along(order[i] % nx, nx);
      if (d + 1 < dims) points[d + 1][i] = along(order[i] / nx, ny);
    }
  }
  return points;
}
Points halton_points(std::size_t n, std::size_t dims = 2) {
  return from_columns(column_of(TRY_MEASURE(halton, n, dims, 0)), dims);
}
Points hammersley_points(std::size_t n, std::size_t dims = 2) {
  return from_columns(column_of(TRY_MEASURE(hammersley, n, dims)), dims);
}
Points sobol_points(std::size_t n, unsigned dims = 2) {
  std::vector<Column> columns;
  for (unsigned d = 0; d < dims; ++d) columns.push_back(column_of(TRY_MEASURE(sobol, d, 0, n)));
  return joined(columns);
}
Points scrambled_points(const Points& points, std::uint64_t seed) {
  if (!points) return {};
  std::vector<Column> columns;
  for (std::size_t d = 0; d < points->size(); ++d) {
    columns.push_back(column_of(TRY_MEASURE(owen_scramble, (*points)[d], {8 * seed + d})));
  }
  return joined(columns);
}

void write_points(const std::string& name, const Points& points) {
  auto file = plot_file(name);
  if (!points) plot_row(file, std::array{Number{}, Number{}});
  if (points) {
    for (std::size_t i = 0; i < (*points)[0].size(); ++i) {
      plot_row(file, std::array{Number((*points)[0][i]), Number((*points)[1][i])});
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
  const auto got = TRY_MEASURE(star_discrepancy_2d, (*points)[0], (*points)[1]);
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

/// What is integrated, and the exact integrals.
struct Integral {
  std::size_t dims;
  double (*g)(std::span<const double>);
  double exact;
};
double smooth(std::span<const double> x) {
  return std::exp(std::accumulate(x.begin(), x.end(), 0.0));
}
double kink(std::span<const double> x) {
  return std::abs(x[0] - 0.4) + std::abs(x[0] + x[1] - 1);
}
double edge(std::span<const double> x) {
  return x[0] * x[0] + x[1] * x[1] < 0.7 ? 1 : 0;
}
const double e_1 = std::exp(1) - 1;
const std::array<Integral, 5> integrals{
    Integral{1, smooth, e_1}, Integral{2, smooth, std::pow(e_1, 2)},
    Integral{4, smooth, std::pow(e_1, 4)},
    Integral{2, kink, 0.26 + 1. / 3},      // (.4^2 + .6^2)/2, and E|x + y - 1|
    Integral{2, edge, 0.7 * std::atan(1)}  // a quarter of a disk of radius sqrt(.7) < 1
};
const Integral& smooth_2d = integrals[1];

Number error(const Points& points, const Integral& integral) {
  if (!points) return {};
  const std::size_t n = (*points)[0].size();
  double sum = 0;
  std::array<double, 4> x{};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < integral.dims; ++d) x[d] = (*points)[d][i];
    sum += integral.g({x.data(), integral.dims}) - integral.exact;
  }
  return std::abs(sum / static_cast<double>(n));
}

/// The root of the mean square over random sets; one set where there is nothing random.
template <class Make>
Number mean_error(const Integral& integral, std::uint64_t sets, Make make) {
  double squares = 0;
  for (std::uint64_t set = 0; set < sets; ++set) {
    const Number one = error(make(set), integral);
    if (!one) return {};
    squares += *one * *one;
  }
  return std::sqrt(squares / static_cast<double>(sets));
}

TEST_CASE("plot error against N", "[.plot]") {
  Rng rng(3);
  for (std::size_t i = 0; i < integrals.size(); ++i) {
    const Integral& integral = integrals[i];
    const auto dims = static_cast<unsigned>(integral.dims);
    auto file = plot_file("convergence-" + std::to_string(i + 1) + ".tsv");
    for (std::size_t n = 16; n <= 65536; n *= 2) {
      const Points sobol = sobol_points(n, dims);
      const auto once = [&](const Points& points) { return error(points, integral); };
      const auto often = [&](auto make) { return mean_error(integral, replicates, make); };
      plot_row(file, std::array{Number(static_cast<double>(n)),
                                often([&](auto) { return random_points(rng, n, dims); }),
                                often([&](auto) { return stratified_points(rng, n, dims); }),
                                once(halton_points(n, dims)), once(hammersley_points(n, dims)),
                                once(sobol),
                                often([&](auto set) { return scrambled_points(sobol, set); })});
    }
  }
}

TEST_CASE("plot the bad pair", "[.plot]") {
  const std::size_t n = 64;
  const Column x = column_of(TRY_MEASURE(radical_inverses, 29, 0, n));
  const Column y = column_of(TRY_MEASURE(radical_inverses, 31, 0, n));
  write_points("pair-1.tsv", joined({x, y}));
  Points shifted;
  if (x && y) {
    Values both = *x;
    both.insert(both.end(), y->begin(), y->end());
    shifted = from_columns(column_of(TRY_MEASURE(random_shift, both, 2, 1, 1)), 2);
  }
  write_points("pair-2.tsv", shifted);
  write_points("pair-3.tsv",
               joined({column_of(TRY_MEASURE(radical_inverses_scrambled, 29, 0, n, {1})),
                       column_of(TRY_MEASURE(radical_inverses_scrambled, 31, 0, n, {2}))}));
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
  const Points halton = halton_points(n), sobol = sobol_points(n);
  const Number scrambled_sobol = mean_error(
      smooth_2d, replicates, [&](auto set) { return scrambled_points(sobol, set + 100); });
  const Number scrambled_halton = mean_error(smooth_2d, replicates, [&](std::uint64_t set) {
    return joined({column_of(TRY_MEASURE(radical_inverses_scrambled, 2, 0, n, {2 * set})),
                   column_of(TRY_MEASURE(radical_inverses_scrambled, 3, 0, n, {2 * set + 1}))});
  });
  const auto both = [](Number x, Number y) { return x && y ? Number(*x + *y) : Number{}; };
  const Number error_halton = error(halton, smooth_2d);
  plot_row(file, std::array{Number(1), both(nanoseconds(1, 2), nanoseconds(1, 3)), error_halton});
  plot_row(file, std::array{Number(2), both(nanoseconds(2, 2), nanoseconds(2, 3)), error_halton});
  plot_row(file, std::array{Number(5), both(nanoseconds(5, 0), nanoseconds(5, 1)),
                            error(sobol, smooth_2d)});
  plot_row(file,
           std::array{Number(8), both(nanoseconds(8, 0), nanoseconds(8, 1)), scrambled_sobol});
  plot_row(file,
           std::array{Number(9), both(nanoseconds(9, 2), nanoseconds(9, 3)), scrambled_halton});
}

}  // namespace
}  // namespace mc::checks
