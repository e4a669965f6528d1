// mistake: the same random number shifts every axis
// caught by: 5.7 the shift is uniform
// hint: one shift for every axis
#include "halton.hpp"

#include <cmath>

#define random_shift right_random_shift
#include "solutions/halton.cpp"
#undef random_shift

namespace mc {

void random_shift(PointSet& points, Rng& rng) {
  const double shift = static_cast<double>(rng() >> 11) * 0x1p-53;
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& value : points.column(d)) {
      value += shift;
      value -= std::floor(value);
    }
  }
}

}  // namespace mc
