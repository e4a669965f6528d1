// alternative: the standard library throughout, one number at a time, clamped below the edge; y is
// drawn before x, cells are taken column by column, patterns are padded by std::shuffle

#include "stratification.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

namespace mc {
namespace {

double place(std::size_t i, std::size_t n, Rng& rng) {
  const double u = std::uniform_real_distribution<double>(0, 1)(rng);
  const auto stratum = static_cast<double>(i), strata = static_cast<double>(n);
  const double edge = (stratum + 1) / strata;
  return std::min((stratum + u) / strata, std::nextafter(edge, 0.0));
}

/// The values in the order that `order` says.
void arrange(std::span<double> values, const std::vector<std::size_t>& order) {
  const std::vector<double> from(values.begin(), values.end());
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = from[order[k]];
}

std::vector<std::size_t> random_order(std::size_t n, Rng& rng) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), rng);
  return order;
}

void require_grid(std::span<const double> x, std::span<const double> y, Grid grid) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y must have one size");
  const auto product = static_cast<long double>(grid.nx) * static_cast<long double>(grid.ny);
  if (product < 1) throw std::invalid_argument("the grid is empty");
  if (product != static_cast<long double>(x.size())) {
    throw std::invalid_argument("the grid does not have as many cells as there are points");
  }
}

}  // namespace

void stratified_1d(std::span<double> x, Rng& rng) {
  for (std::size_t i = x.size(); i-- > 0;) x[i] = place(i, x.size(), rng);
}

Grid strata(std::size_t n) {
  if (n == 0) throw std::invalid_argument("n must not be 0");
  auto ny = static_cast<std::size_t>(std::sqrt(static_cast<double>(n))) + 1;
  while (n % ny != 0 || n / ny < ny) --ny;
  return {n / ny, ny};
}

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  for (std::size_t i = 0; i < grid.nx; ++i) {
    for (std::size_t j = 0; j < grid.ny; ++j) {
      y[i * grid.ny + j] = place(j, grid.ny, rng);
      x[i * grid.ny + j] = place(i, grid.nx, rng);
    }
  }
}

void shuffle(std::span<double> x, Rng& rng) {
  std::shuffle(x.begin(), x.end(), rng);
}

void stratified(PointSet& points, Rng& rng) {
  const std::size_t n = points.size();
  if (points.dims() % 2 == 1) {
    const auto last = points.column(points.dims() - 1);
    stratified_1d(last, rng);
    arrange(last, random_order(n, rng));
  }
  for (std::size_t d = 1; d < points.dims(); d += 2) {
    const auto x = points.column(d - 1), y = points.column(d);
    stratified_2d(x, y, strata(n), rng);
    const auto order = random_order(n, rng);
    arrange(x, order);
    arrange(y, order);
  }
}

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  const auto cells = std::pow(static_cast<long double>(per_axis), points.dims());
  if (per_axis == 0 || cells != static_cast<long double>(points.size())) {
    throw std::invalid_argument("per_axis: its power is not the number of points");
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    std::size_t rest = k;
    for (std::size_t d = points.dims(); d-- > 0; rest /= per_axis) {
      points.column(d)[k] = place(rest % per_axis, per_axis, rng);
    }
  }
}

void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    stratified_1d(points.column(d), rng);
    if (d > 0) shuffle(points.column(d), rng);  // the first axis may stay in order
  }
}

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const std::size_t n = x.size();
  std::vector<std::vector<std::size_t>> in_column, in_row;
  for (std::size_t i = 0; i < grid.nx; ++i) in_column.push_back(random_order(grid.ny, rng));
  for (std::size_t j = 0; j < grid.ny; ++j) in_row.push_back(random_order(grid.nx, rng));
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = place(i * grid.ny + in_column[i][j], n, rng);
    y[k] = place(j * grid.nx + in_row[j][i], n, rng);
  }
}

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (n < 1) throw std::invalid_argument("n must be at least 1");
  if (replicates < 1) throw std::invalid_argument("replicates must be at least 1");
  std::vector<double> means, values(n), point(g.dims);
  for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
    PointSet points(n, g.dims);
    generator(points, rng);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t d = 0; d < g.dims; ++d) point[d] = points.column(d)[i];
      values[i] = g.f(point);
    }
    means.push_back(mean(values));
  }
  return {mean(means), std::sqrt(variance_two_pass(means) / static_cast<double>(replicates)),
          n * replicates};
}

Estimate irradiance_stratified(const RectLight& light, Grid grid, std::uint64_t replicates,
                               Rng& rng) {
  if (grid.nx == 0) throw std::invalid_argument("grid: nx must not be 0");
  if (grid.ny == 0) throw std::invalid_argument("grid: ny must not be 0");
  if (replicates == 0) throw std::invalid_argument("replicates must not be 0");
  std::vector<double> means(replicates), x(grid.nx * grid.ny), y(x.size());
  for (double& mean : means) {
    stratified_2d(x, y, grid, rng);
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double px = light.x0 + (light.x1 - light.x0) * x[k];
      const double py = light.y0 + (light.y1 - light.y0) * y[k];
      const double distance = std::hypot(px, py, light.height), cosine = light.height / distance;
      mean += light.radiance * cosine * cosine / (distance * distance);
    }
    mean *= (light.x1 - light.x0) * (light.y1 - light.y0) / static_cast<double>(x.size());
  }
  const double error = std::sqrt(variance_two_pass(means) / static_cast<double>(replicates));
  return {mc::mean(means), error, x.size() * replicates};
}

}  // namespace mc
