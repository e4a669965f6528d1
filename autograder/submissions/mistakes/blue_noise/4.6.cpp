// Mistakes in task 4.6.
#include "blue_noise.hpp"

#define tile right_tile
#include "solutions/blue_noise.cpp"
#undef tile

// mistake: divides the index of a copy by the number of copies as integers, which gives 0
// hint: i / copies of two integers is 0
namespace mc::copies_in_whole_numbers {
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
}  // namespace mc::copies_in_whole_numbers

// mistake: mirrors every other copy, so that equal edges meet
// hint: do not rotate, mirror or move the pattern
namespace mc::mirrored_copies {
PointSet tile(const PointSet& pattern, int copies) {
  PointSet tiled = right_tile(pattern, copies);
  for (double& value : tiled.column(0)) {
    const double cell = std::floor(value * copies), within = value * copies - cell;
    if (std::fmod(cell, 2) == 1) value = std::min((cell + 1 - within) / copies, 1 - 0x1p-53);
  }
  return tiled;
}
}  // namespace mc::mirrored_copies

// mistake: lets the last coordinate round up to 1
// hint: the upper end is not in the range
namespace mc::rounded_up_to_one {
PointSet tile(const PointSet& pattern, int copies) {
  PointSet tiled = right_tile(pattern, copies);
  for (const std::size_t d : {0u, 1u}) {
    for (double& value : tiled.column(d)) value = value == 1 - 0x1p-53 ? 1 : value;
  }
  return tiled;
}
}  // namespace mc::rounded_up_to_one

// mistake: returns a point set with a third dimension, which is never written
// hint: dimensions, not 2
namespace mc::third_dimension {
PointSet tile(const PointSet& pattern, int copies) {
  const PointSet tiled = right_tile(pattern, copies);
  PointSet points(tiled.size(), 3);
  for (const std::size_t d : {0u, 1u}) {
    std::copy(tiled.column(d).begin(), tiled.column(d).end(), points.column(d).begin());
  }
  return points;
}
}  // namespace mc::third_dimension
