// peer: the C++ standard library: loops over std::mt19937_64 and uniform_real, std::shuffle
#include "stratification.hpp"

#include <algorithm>
#include <random>
#include <stdexcept>

#include "common/todo.hpp"

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  std::mt19937_64 engine(rng());
  std::uniform_real_distribution<double> random(0.0, 1.0);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = (static_cast<double>(i) + random(engine)) / static_cast<double>(x.size());
  }
}

void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  const bool fits =
      grid.nx > 0 && grid.ny > 0 && x.size() % grid.nx == 0 && x.size() / grid.nx == grid.ny;
  if (!fits) throw std::invalid_argument("grid: nx * ny is not the size of x");
  std::mt19937_64 engine(rng());
  std::uniform_real_distribution<double> random(0.0, 1.0);
  for (std::size_t j = 0; j < grid.ny; ++j) {
    for (std::size_t i = 0; i < grid.nx; ++i) {
      x[j * grid.nx + i] = (static_cast<double>(i) + random(engine)) / static_cast<double>(grid.nx);
      y[j * grid.nx + i] = (static_cast<double>(j) + random(engine)) / static_cast<double>(grid.ny);
    }
  }
}

void shuffle(std::span<double> x, Rng& rng) {
  std::shuffle(x.begin(), x.end(), rng);
}

Grid strata(std::size_t) {
  throw todo("3.2");
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
Estimate estimate_replicated(const Integrand&, const Generator&, std::uint64_t, std::uint64_t,
                             Rng&) {
  throw todo("3.8");
}

Estimate irradiance_stratified(const RectLight&, Grid, std::uint64_t, Rng&) {
  throw todo("3.9");
}

}  // namespace mc
