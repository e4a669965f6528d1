// Mistakes in task 5.7.
#include "halton.hpp"

#include <cmath>

#define random_shift right_random_shift
#include "solutions/halton.cpp"
#undef random_shift

namespace mc {
namespace {

/// Adds shift(d) to each point, modulo 1.
template <class Shift>
void shift_by(PointSet& points, Shift shift) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& value : points.column(d)) {
      value += shift(d);
      value -= std::floor(value);
    }
  }
}

double any(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

}  // namespace
}  // namespace mc

// mistake: shifts each point by its own random vector, which makes the points independent
// hint: not one per point
namespace mc::a_shift_for_each_point {
void random_shift(PointSet& points, Rng& rng) {
  shift_by(points, [&](std::size_t) { return any(rng); });
}
}  // namespace mc::a_shift_for_each_point

// mistake: shifts every axis by the same random number
// hint: the same shift on every axis
namespace mc::one_shift_for_all_axes {
void random_shift(PointSet& points, Rng& rng) {
  shift_by(points, [shift = any(rng)](std::size_t) { return shift; });
}
}  // namespace mc::one_shift_for_all_axes

// mistake: shifts by its own generator, which starts again in every call
// hint: in every set: draw it from the given generator
namespace mc::same_shift_each_time {
void random_shift(PointSet& points, Rng& /*rng*/) {
  Rng own(1);
  right_random_shift(points, own);
}
}  // namespace mc::same_shift_each_time

// mistake: does not wrap shifted points around at 1
// hint: subtract 1 if the sum is 1 or more
namespace mc::shift_without_wrapping {
void random_shift(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const double shift = any(rng);
    for (double& value : points.column(d)) value += shift;
  }
}
}  // namespace mc::shift_without_wrapping

// mistake: shifts by a random number of thousandths
// hint: the random numbers are multiples of 1/1000
namespace mc::shifts_by_thousandths {
void random_shift(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const double shift = static_cast<double>(rng() % 1000) / 1000;
    for (double& value : points.column(d)) value = std::fmod(value + shift, 1.0);
  }
}
}  // namespace mc::shifts_by_thousandths

// mistake: has an array of 32 shifts and begins again at the 33rd axis
// hint: the same shift on every axis
namespace mc::shifts_of_32_axes {
void random_shift(PointSet& points, Rng& rng) {
  std::array<double, 32> shifts;
  for (double& shift : shifts) shift = any(rng);
  shift_by(points, [&](std::size_t d) { return shifts[d % shifts.size()]; });
}
}  // namespace mc::shifts_of_32_axes
