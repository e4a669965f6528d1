// mistake: each point is shifted by itself, and becomes a random one
// caught by: 5.7 one shift moves
// caught by: 5.7 the shift is uniform
// caught by: 5.7 shifted points stay
// hint: not one for a point
#include "halton.hpp"

#include <cmath>

#define random_shift right_random_shift
#include "solutions/halton.cpp"
#undef random_shift

namespace mc {

void random_shift(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& value : points.column(d)) {
      value += static_cast<double>(rng() >> 11) * 0x1p-53;
      value -= std::floor(value);
    }
  }
}

}  // namespace mc
