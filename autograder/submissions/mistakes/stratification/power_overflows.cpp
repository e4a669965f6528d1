// mistake: compares per_axis^dims with N in 64 bits, where it wraps around
// caught by: 3.5 sizes that are no power are refused
// hint: wraps around: divide, before anything is computed
#include "stratification.hpp"
#define stratified_nd right_stratified_nd
#include "solutions/stratification.cpp"
#undef stratified_nd

namespace mc {

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  std::size_t cells = 1;
  for (std::size_t d = 0; d < points.dims(); ++d) cells *= per_axis;
  if (per_axis == 0 || cells != points.size()) {
    throw std::invalid_argument("per_axis: per_axis^dims is not the number of points");
  }
  if (per_axis <= points.size()) return right_stratified_nd(points, per_axis, rng);
  latin_hypercube(points, rng);
}

}  // namespace mc
