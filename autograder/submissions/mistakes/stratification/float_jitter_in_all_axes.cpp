// mistake: jitter of 24 random bits over all dimensions
// caught by: 3.5 each point is uniform in its cell
// hint: the random numbers have too few bits
#include "stratification.hpp"

#include <cmath>

#define stratified_nd right_stratified_nd
#include "solutions/stratification.cpp"
#undef stratified_nd

namespace mc {

void stratified_nd(PointSet& points, std::size_t per_axis, Rng& rng) {
  right_stratified_nd(points, per_axis, rng);
  const Strata strata(per_axis);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& x : points.column(d)) {
      const auto jitter = static_cast<float>(rng() >> 40) * 0x1p-24f;
      x = strata.place(std::floor(x * static_cast<double>(per_axis)), jitter);
    }
  }
}

}  // namespace mc
