// mistake: lets the last coordinate be rounded up to 1
// caught by: 4.6 copies lie side by side
// hint: it was rounded up to the upper end
#include "blue_noise.hpp"
#define tile right_tile
#include "solutions/blue_noise.cpp"
#undef tile

namespace mc {

PointSet tile(const PointSet& pattern, int copies) {
  PointSet tiled = right_tile(pattern, copies);
  std::size_t i = 0;
  for (int row = 0; row < copies; ++row) {
    for (int column = 0; column < copies; ++column) {
      for (std::size_t p = 0; p < pattern.size(); ++p, ++i) {
        tiled.column(0)[i] = (column + pattern.column(0)[p]) / copies;
        tiled.column(1)[i] = (row + pattern.column(1)[p]) / copies;
      }
    }
  }
  return tiled;
}

}  // namespace mc
