// mistake: mirrors every other copy, so that patterns meet like with like at their seams
// caught by: 4.6 copies lie side by side
// caught by: 4.6 a tiled pattern has power
// hint: nothing is turned, mirrored or moved
#include "blue_noise.hpp"
#define tile right_tile
#include "solutions/blue_noise.cpp"
#undef tile

namespace mc {

PointSet tile(const PointSet& pattern, int copies) {
  PointSet tiled = right_tile(pattern, copies);
  const auto x = tiled.column(0);
  for (double& value : x) {
    const double cell = std::floor(value * copies);
    const double within = value * copies - cell;
    if (static_cast<int>(cell) % 2 == 1)
      value = std::min((cell + 1 - within) / copies, 1 - 0x1p-53);
  }
  return tiled;
}

}  // namespace mc
