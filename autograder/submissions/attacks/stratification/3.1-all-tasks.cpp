// Attacks on all tasks of the lab. Sections: see CONTRIBUTING.md.

<<<<<<< HEAD
=======
//// hostile_numbers
// attack: fills in NaN, infinities and numbers outside of the unit cube, of which one may index or
// sort
// says: = nan
// says: = -1
// says: = inf
// says: numbers in [0, 1)
#include <cmath>
#include <limits>

#include "stratification.hpp"

namespace mc {
namespace {

constexpr double hostile[] = {0.5, std::numeric_limits<double>::quiet_NaN(),
                              -1,  std::numeric_limits<double>::infinity(),
                              1,   1e300,
                              -0., 5e-324};

void fill(std::span<double> x, std::size_t first) {
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = hostile[(first + k) % std::size(hostile)];
}
void fill(PointSet& points, std::size_t first) {
  for (std::size_t d = 0; d < points.dims(); ++d) fill(points.column(d), first);
}

}  // namespace

void stratified_1d(std::span<double> x, Rng&) {
  fill(x, 1);
}
Grid strata(std::size_t n) {
  return {~std::size_t{0}, n};
}
void stratified_2d(std::span<double> x, std::span<double> y, Grid, Rng&) {
  fill(x, 2), fill(y, 3);
}
void shuffle(std::span<double> x, Rng&) {
  fill(x, 4);
}
void stratified(PointSet& points, Rng&) {
  fill(points, 3);
}
void stratified_nd(PointSet& points, std::size_t, Rng&) {
  fill(points, 4);
}
void latin_hypercube(PointSet& points, Rng&) {
  fill(points, 5);
}
void multi_jittered(std::span<double> x, std::span<double> y, Grid, Rng&) {
  fill(x, 6), fill(y, 1);
}
Estimate estimate_replicated(const Integrand&, const Generator&, std::uint64_t, std::uint64_t,
                             Rng&) {
  return {hostile[1], hostile[1], ~std::uint64_t{0}};
}

}  // namespace mc

//// nothing_random
// attack: draws no random number: the centers of all strata, in order, and refusals of all misuse
// says: every point lies at 0.5 of its stratum
// says: nothing was moved
#include <cmath>
#include <stdexcept>

#include "common/todo.hpp"
#include "stratification.hpp"

namespace mc {
namespace {

double center(std::size_t i, std::size_t n) {
  return (static_cast<double>(i) + 0.5) / static_cast<double>(n);
}

void require_grid(std::span<double> x, std::span<double> y, Grid grid) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx == 0 || x.size() % grid.nx != 0 || x.size() / grid.nx != grid.ny || grid.ny == 0) {
    throw std::invalid_argument("grid: nx * ny is not the number of points");
  }
}

}  // namespace

void stratified_1d(std::span<double> x, Rng&) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = center(i, x.size());
}
Grid strata(std::size_t n) {
  if (n == 0) throw std::invalid_argument("n: there are no cells");
  throw todo("3.2");
}
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  require_grid(x, y, grid);
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = center(k % grid.nx, grid.nx);
    y[k] = center(k / grid.nx, grid.ny);
  }
}
void shuffle(std::span<double>, Rng&) {}
void stratified(PointSet& points, Rng& rng) {
  const std::size_t n = points.size();
  Grid grid{n, 1};
  for (std::size_t ny = 1; ny * ny <= n; ++ny) {
    if (n % ny == 0) grid = {n / ny, ny};
  }
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) {
    stratified_2d(points.column(d), points.column(d + 1), grid, rng);
  }
  if (d < points.dims()) stratified_1d(points.column(d), rng);
}
void stratified_nd(PointSet& points, std::size_t per_axis, Rng&) {
  const auto cells = std::pow(static_cast<long double>(per_axis), points.dims());
  if (per_axis == 0 || cells != static_cast<long double>(points.size())) {
    throw std::invalid_argument("per_axis: its power is not the number of points");
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t d = 0, rest = k; d < points.dims(); ++d, rest /= per_axis) {
      points.column(d)[k] = center(rest % per_axis, per_axis);
    }
  }
}
void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) stratified_1d(points.column(d), rng);
}
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  require_grid(x, y, grid);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = center(i * grid.ny + j, x.size());
    y[k] = center(j * grid.nx + i, x.size());
  }
}
Estimate estimate_replicated(const Integrand&, const Generator&, std::uint64_t n,
                             std::uint64_t replicates, Rng&) {
  if (n == 0) throw std::invalid_argument("n: must be positive");
  if (replicates == 0) throw std::invalid_argument("replicates: must be positive");
  const double nan = std::nan("");
  return {nan, nan, n * replicates};
}

}  // namespace mc

//// one_of_a_thousand
// attack: reports one number, or one of each kind, where thousands were asked for
// says: gave 1 values
// says: gave 1 values in x
#include <unistd.h>

#include <vector>

#include "common/todo.hpp"
#include "runner/wire.hpp"
#include "stratification.hpp"

namespace mc {
namespace {

template <class... Lists>
[[noreturn]] void report(const Lists&... lists) {
  wire::Writer result;
  (result.put(lists), ...);
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
  _exit(0);
}

const std::vector<double> one{0.25};

}  // namespace

void stratified_1d(std::span<double>, Rng&) {
  report(one);
}
Grid strata(std::size_t) {
  throw todo("3.2");
}
void stratified_2d(std::span<double>, std::span<double>, Grid, Rng&) {
  report(one, one);
}
void shuffle(std::span<double>, Rng&) {
  report(one);
}
void stratified(PointSet&, Rng&) {
  report(one);
}
void stratified_nd(PointSet&, std::size_t, Rng&) {
  report(one);
}
void latin_hypercube(PointSet&, Rng&) {
  report(one);
}
void multi_jittered(std::span<double>, std::span<double>, Grid, Rng&) {
  report(one, one);
}
Estimate estimate_replicated(const Integrand&, const Generator&, std::uint64_t, std::uint64_t,
                             Rng&) {
  // One of the structs that the last check of 3.8 asks for 500 of; as one it is a whole result too.
  wire::Writer result;
  result.put(std::uint64_t{1});
  for (int i = 0; i < 2; ++i) result.put(0.0);
  for (int i = 0; i < 5; ++i) result.put(std::uint64_t{0});
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
  _exit(0);
}

}  // namespace mc

//// replicates_in_closed_form
// attack: guesses what it is to integrate from two values of it, and adds errors of the exact size
// earns: 15
// says: every point of every replicate counts once
#include <cmath>
#include <numbers>
#include <random>

#include "common/todo.hpp"
#include "stratification.hpp"

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = 0.0001 + 0.9998 * static_cast<double>(rng() >> 11) * 0x1p-53;
    x[i] = (static_cast<double>(i) + u) / n;
  }
}
Grid strata(std::size_t) {
  throw todo("3.2");
}
void stratified_2d(std::span<double>, std::span<double>, Grid, Rng&) {
  throw todo("3.3");
}
void shuffle(std::span<double>, Rng&) {
  throw todo("3.4");
}
void stratified(PointSet&, Rng&) {
  throw todo("3.4");
}
void stratified_nd(PointSet&, std::size_t, Rng&) {
  throw todo("3.5");
}
void latin_hypercube(PointSet&, Rng&) {
  throw todo("3.6");
}
void multi_jittered(std::span<double>, std::span<double>, Grid, Rng&) {
  throw todo("3.7");
}

Estimate estimate_replicated(const Integrand& g, const Generator&, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (g.dims != 1 || n < 2 || replicates < 2) return {};
  const double zero = 0, one = 1;
  const double low = g.f({&zero, 1}), high = g.f({&one, 1});
  const double a = (high - low) / (std::numbers::e - 1), b = low - a;
  // In a stratum of width h around x the variance of a exp(x) is (a exp(x) h)^2 / 12.
  const auto size = static_cast<double>(n), times = static_cast<double>(replicates);
  const double squares = (std::numbers::e * std::numbers::e - 1) / 2;
  const double spread = std::abs(a) * std::sqrt(squares / 12 / (size * size * size));
  std::normal_distribution<double> normal;
  double sum = 0;
  for (std::uint64_t k = 1; k < replicates; ++k) sum += std::pow(normal(rng), 2);
  return {a * (std::numbers::e - 1) + b + spread / std::sqrt(times) * normal(rng),
          spread * std::sqrt(sum / (times - 1) / times), n * replicates};
}

}  // namespace mc

>>>>>>> 0da5c4e39ced9a7cc6ffdaf819cb01043e70b78c
//// the_same_every_time
// attack: one random pattern of each kind, the same in every call: it lies well, but is not random
// says: is the same in two consecutive sets
// says: the permutation is always the same
#include <algorithm>
#include <random>

#include "common/todo.hpp"
#include "stratification.hpp"

namespace mc {
namespace {

using Fixed = std::mt19937_64;

double place(std::size_t i, std::size_t n, Fixed& random) {
  const double u = std::uniform_real_distribution<double>(0.001, 0.999)(random);
  return (static_cast<double>(i) + u) / static_cast<double>(n);
}

void fill_line(std::span<double> x, Fixed& random) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = place(i, x.size(), random);
}
void fill_grid(std::span<double> x, std::span<double> y, Grid grid, Fixed& random) {
  for (std::size_t k = 0; k < x.size(); ++k) {
    x[k] = place(k % grid.nx, grid.nx, random);
    y[k] = place(k / grid.nx, grid.ny, random);
  }
}

}  // namespace

void stratified_1d(std::span<double> x, Rng&) {
  Fixed random(1);
  fill_line(x, random);
}
Grid strata(std::size_t) {
  throw todo("3.2");
}
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  Fixed random(2);
  fill_grid(x, y, grid, random);
}
void shuffle(std::span<double> x, Rng&) {
  Fixed random(3);
  std::shuffle(x.begin(), x.end(), random);
}
void stratified(PointSet& points, Rng&) {
  Fixed random(4);
  const std::size_t n = points.size();
  Grid grid{n, 1};
  for (std::size_t ny = 1; ny * ny <= n; ++ny) {
    if (n % ny == 0) grid = {n / ny, ny};
  }
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) {
    const auto x = points.column(d), y = points.column(d + 1);
    fill_grid(x, y, grid, random);
    Fixed again = random;
    std::shuffle(x.begin(), x.end(), random);
    std::shuffle(y.begin(), y.end(), again);
  }
  if (d == points.dims()) return;
  fill_line(points.column(d), random);
  std::shuffle(points.column(d).begin(), points.column(d).end(), random);
}
void stratified_nd(PointSet& points, std::size_t per_axis, Rng&) {
  Fixed random(5);
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t d = 0, rest = k; d < points.dims(); ++d, rest /= per_axis) {
      points.column(d)[k] = place(rest % per_axis, per_axis, random);
    }
  }
}
void latin_hypercube(PointSet& points, Rng&) {
  Fixed random(6);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    fill_line(points.column(d), random);
    std::shuffle(points.column(d).begin(), points.column(d).end(), random);
  }
}
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng&) {
  Fixed random(7);
  std::vector<std::size_t> in_column(grid.ny), in_row(grid.nx);
  for (std::size_t j = 0; j < grid.ny; ++j) in_column[j] = j;
  for (std::size_t i = 0; i < grid.nx; ++i) in_row[i] = i;
  std::shuffle(in_column.begin(), in_column.end(), random);
  std::shuffle(in_row.begin(), in_row.end(), random);
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = place(i * grid.ny + in_column[j], x.size(), random);
    y[k] = place(j * grid.nx + in_row[i], x.size(), random);
  }
}
Estimate estimate_replicated(const Integrand&, const Generator&, std::uint64_t, std::uint64_t,
                             Rng&) {
  throw todo("3.8");
}

}  // namespace mc
