// mistake: divides the number of a copy by their number as whole numbers, which gives 0
// caught by: 4.6 copies lie side by side
// caught by: 4.6 a tiled pattern has power
// hint: i / copies of two whole numbers is 0
#include "blue_noise.hpp"

#define tile right_tile
#include "solutions/blue_noise.cpp"
#undef tile

namespace mc {

PointSet tile(const PointSet& pattern, int copies) {
  PointSet tiled = right_tile(pattern, copies);
  for (const std::size_t d : {0u, 1u}) {
    for (double& value : tiled.column(d)) {
      const double cell = std::floor(value * copies);
      value = std::max(0.0, value - cell / copies) + static_cast<int>(cell) / copies;
    }
  }
  return tiled;
}

}  // namespace mc
