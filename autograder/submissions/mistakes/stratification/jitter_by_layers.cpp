// mistake: x is jittered once for each layer of cells, and so for every axis
// caught by: 3.5 each point is uniform in its cell
// caught by: 3.5 the curse of dimension
// hint: the same random number moves both
#include "stratification.hpp"
#define stratified_nd right_stratified_nd
#include "solutions/stratification.cpp"
#undef stratified_nd

namespace mc {

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);
  std::vector<double> layers(per_axis);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    stratified_1d(layers, rng);
    for (double& x : points.column(d)) {
      x = layers[static_cast<std::size_t>(x * static_cast<double>(per_axis))];
    }
  }
}

}  // namespace mc
