// Mistakes in task 3.7.
#include "stratification.hpp"

#include <cmath>

#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

// mistake: leaves the canonical arrangement unshuffled
// hint: this is the canonical arrangement
namespace mc::canonical_arrangement {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const Strata fine(x.size());
  for (std::size_t i = 0; i < grid.nx; ++i) {
    for (std::size_t j = 0; j < grid.ny; ++j) {
      const std::size_t k = i * grid.ny + j;
      x[k] = fine.place(static_cast<double>(i * grid.ny + j), to_unit(rng()));
      y[k] = fine.place(static_cast<double>(j * grid.nx + i), to_unit(rng()));
    }
  }
}
}  // namespace mc::canonical_arrangement

// mistake: jitters multi-jittered points with 24 random bits
// hint: the random numbers have too few bits
namespace mc::float_multi_jitter {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_multi_jittered(x, y, grid, rng);
  const Strata fine(x.size());
  for (const auto column : {x, y}) {
    for (double& value : column) {
      const auto jitter = static_cast<float>(rng() >> 40) * 0x1p-24f;
      value = fine.place(std::floor(value * static_cast<double>(x.size())), jitter);
    }
  }
}
}  // namespace mc::float_multi_jitter

// mistake: shuffles x and y of multi-jittered points separately
// hint: two 1D patterns are not a 2D pattern: fill the cells
namespace mc::multi_jittered_apart {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_multi_jittered(x, y, grid, rng);
  shuffle(x, rng);
  shuffle(y, rng);
}
}  // namespace mc::multi_jittered_apart

// mistake: moves all multi-jittered points by one random number along x, and one along y
// hint: share one random number
namespace mc::one_jitter_for_all_points {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_multi_jittered(x, y, grid, rng);
  const Strata fine(x.size());
  for (const auto column : {x, y}) {
    const double u = to_unit(rng());
    for (double& value : column) {
      value = fine.place(std::floor(value * static_cast<double>(x.size())), u);
    }
  }
}
}  // namespace mc::one_jitter_for_all_points

// mistake: uses one permutation for columns and rows of a square grid
// hint: random permutations, all equally likely
namespace mc::one_permutation_for_both {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (grid.nx != grid.ny) return right_multi_jittered(x, y, grid, rng);
  require_grid(x, y, grid);
  std::vector<double> order(grid.nx);
  std::iota(order.begin(), order.end(), 0.0);
  shuffle(order, rng);
  const Strata fine(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t i = k % grid.nx, j = k / grid.nx;
    x[k] = fine.place(static_cast<double>(i * grid.ny) + order[j], to_unit(rng()));
    y[k] = fine.place(static_cast<double>(j * grid.nx) + order[i], to_unit(rng()));
  }
}
}  // namespace mc::one_permutation_for_both

// mistake: fills the cells of the plane but does not stratify the axes
// hint: each column of cells has ny strata of x
namespace mc::only_jittered {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  stratified_2d(x, y, grid, rng);
}
}  // namespace mc::only_jittered

// mistake: stratifies both axes but not the cells of the plane
// hint: two 1D patterns are not a 2D pattern
namespace mc::only_the_axes {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  stratified_1d(x, rng);
  stratified_1d(y, rng);
  shuffle(y, rng);
}
}  // namespace mc::only_the_axes

// mistake: compares nx * ny in 64 bits, and allocates nx columns
// hint: the product of 64-bit numbers wraps around
namespace mc::room_for_an_overflow {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (grid.nx * grid.ny != x.size() || x.empty()) {
    throw std::invalid_argument("grid: nx * ny is not the number of points");
  }
  const std::vector<double> columns(grid.nx);
  right_multi_jittered(x, y, grid, rng);
}
}  // namespace mc::room_for_an_overflow

// mistake: shuffles the strata of x within their columns, but not those of y
// hint: x is shuffled and y is not
namespace mc::shuffles_x_only {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  require_grid(x, y, grid);
  const Strata fine(x.size());
  stratified_1d(x, rng);
  for (std::size_t i = 0; i < grid.nx; ++i) {
    shuffle(x.subspan(i * grid.ny, grid.ny), rng);
    for (std::size_t j = 0; j < grid.ny; ++j) {
      y[i * grid.ny + j] = fine.place(static_cast<double>(j * grid.nx + i), to_unit(rng()));
    }
  }
}
}  // namespace mc::shuffles_x_only

// mistake: the jitter of y is 1 - the jitter of x
// hint: with its own u
namespace mc::mirrored_jitter {
void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_multi_jittered(x, y, grid, rng);
  const auto n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double jitter = x[k] * n - std::floor(x[k] * n);
    y[k] = (std::floor(y[k] * n) + 0.5 + 0.999999 * (0.5 - jitter)) / n;
  }
}
}  // namespace mc::mirrored_jitter
