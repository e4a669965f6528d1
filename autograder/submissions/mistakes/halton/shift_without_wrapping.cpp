// mistake: shifted points leave the unit cube
// caught by: 5.7 one shift moves
// caught by: 5.7 shifted points stay
// hint: it left the unit interval
#include "halton.hpp"

#define random_shift right_random_shift
#include "solutions/halton.cpp"
#undef random_shift

namespace mc {

void random_shift(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const double shift = static_cast<double>(rng() >> 11) * 0x1p-53;
    for (double& value : points.column(d)) value += shift;
  }
}

}  // namespace mc
