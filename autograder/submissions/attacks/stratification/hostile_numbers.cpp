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
