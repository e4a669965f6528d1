// alternative: every order, also that of a Latin hypercube and of multi-jittering, comes from
// sorting random keys

#include "stratification.hpp"

#include <algorithm>
#include <utility>

#define shuffle right_shuffle
#define latin_hypercube right_latin_hypercube
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef shuffle
#undef latin_hypercube
#undef multi_jittered

namespace mc {
namespace {

/// Which of n random keys is the smallest, which the next one …: a random order.
std::vector<std::size_t> random_order(std::size_t n, Rng& rng) {
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  for (std::size_t i = 0; i < n; ++i) keys.emplace_back(rng(), i);
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order;
  for (const auto& [key, i] : keys) order.push_back(i);
  return order;
}

}  // namespace

void shuffle(std::span<double> x, Rng& rng) {
  const std::vector<double> from(x.begin(), x.end());
  const auto order = random_order(x.size(), rng);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = from[order[i]];
}

void latin_hypercube(PointSet& points, Rng& rng) {
  const Strata strata(points.size());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto rank = random_order(points.size(), rng);
    for (std::size_t k = 0; k < points.size(); ++k) {
      points.column(d)[k] = strata.place(static_cast<double>(rank[k]), to_unit(rng()));
    }
  }
}

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  // Column i of cells takes the strata i ny … of x; which of its points is in which row is as
  // random as the order of keys. And so for y.
  const Strata fine(x.size());
  for (std::size_t i = 0; i < grid.nx; ++i) {
    const auto order = random_order(grid.ny, rng);
    for (std::size_t j = 0; j < grid.ny; ++j) {
      x[i * grid.ny + j] = fine.place(static_cast<double>(i * grid.ny + order[j]), to_unit(rng()));
    }
  }
  for (std::size_t j = 0; j < grid.ny; ++j) {
    const auto order = random_order(grid.nx, rng);
    for (std::size_t i = 0; i < grid.nx; ++i) {
      y[i * grid.ny + j] = fine.place(static_cast<double>(j * grid.nx + order[i]), to_unit(rng()));
    }
  }
}

}  // namespace mc
