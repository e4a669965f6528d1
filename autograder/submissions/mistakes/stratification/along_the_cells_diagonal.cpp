// mistake: one random number moves a point along all axes of its cell
// caught by: 3.5 each point is uniform in its cell
// caught by: 3.5 the curse of dimension
// hint: the same random number moves the point along two axes
#include "stratification.hpp"

#include <cmath>

#define stratified_nd right_stratified_nd
#include "solutions/stratification.cpp"
#undef stratified_nd

namespace mc {

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);
  const Strata strata(per_axis);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double u = to_unit(rng());
    for (std::size_t d = 0; d < points.dims(); ++d) {
      double& x = points.column(d)[k];
      x = strata.place(std::floor(x * static_cast<double>(per_axis)), u);
    }
  }
}

}  // namespace mc
