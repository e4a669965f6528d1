// mistake: stratifies every axis by itself and calls that a grid
// caught by: 3.5 one point in each cell of all dimensions
// caught by: 3.5 each point is uniform in its cell
// caught by: 3.5 the curse of dimension
// hint: strata are the digits of k in base per_axis
#include "stratification.hpp"
#define stratified_nd right_stratified_nd
#include "solutions/stratification.cpp"
#undef stratified_nd

namespace mc {

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);  // throws what is to be thrown
  latin_hypercube(points, rng);
}

}  // namespace mc
