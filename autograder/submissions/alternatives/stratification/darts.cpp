// alternative: points are thrown at random, and kept where they hit a cell that is still empty; so
// cells are filled in random order, and nothing is left to shuffle

#include "stratification.hpp"
#define stratified right_stratified
#define stratified_nd right_stratified_nd
#define latin_hypercube right_latin_hypercube
#include "solutions/stratification.cpp"
#undef stratified
#undef stratified_nd
#undef latin_hypercube

namespace mc {
namespace {

/// Fills columns first, first + 1, … with points of a grid of cells[0] x cells[1] x …
void throw_darts(PointSet& points, std::size_t first, const std::vector<std::size_t>& cells,
                 Rng& rng) {
  std::vector<bool> taken(points.size());
  std::vector<double> dart(cells.size());
  for (std::size_t k = 0; k < points.size();) {
    std::size_t cell = 0;
    for (std::size_t axis = 0; axis < cells.size(); ++axis) {
      const double u = to_unit(rng());
      const double scaled = u * static_cast<double>(cells[axis]);
      const auto stratum = static_cast<std::size_t>(scaled);
      dart[axis] = Strata(cells[axis])
                       .place(static_cast<double>(stratum), scaled - static_cast<double>(stratum));
      cell = cell * cells[axis] + stratum;
    }
    if (taken[cell]) continue;
    taken[cell] = true;
    for (std::size_t axis = 0; axis < cells.size(); ++axis) {
      points.column(first + axis)[k] = dart[axis];
    }
    ++k;
  }
}

}  // namespace

void stratified(PointSet& points, Rng& rng) {
  const Grid grid = strata(points.size());
  std::size_t d = 0;
  for (; d + 1 < points.dims(); d += 2) throw_darts(points, d, {grid.nx, grid.ny}, rng);
  if (d < points.dims()) throw_darts(points, d, {points.size()}, rng);
}

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);  // throws what is to be thrown
  throw_darts(points, 0, std::vector<std::size_t>(points.dims(), per_axis), rng);
}

void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) throw_darts(points, d, {points.size()}, rng);
}

}  // namespace mc
