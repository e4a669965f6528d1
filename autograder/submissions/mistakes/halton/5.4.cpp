// Mistakes in task 5.4.
#include "halton.hpp"

#define hammersley right_hammersley
#include "solutions/halton.cpp"
#undef hammersley

// mistake: uses (i + 1/2)/N along the first axis
// hint: this is the centered variant
namespace mc::centred_hammersley {
void hammersley(PointSet& points) {
  right_hammersley(points);
  for (double& x : points.column(0)) x += 0.5 / static_cast<double>(points.size());
}
}  // namespace mc::centred_hammersley

// mistake: divides i by N as integers, which gives 0
// hint: i / N of two integers is 0
namespace mc::hammersley_in_whole_numbers {
void hammersley(PointSet& points) {
  right_hammersley(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points.column(0)[i] = static_cast<double>(i / points.size());
  }
}
}  // namespace mc::hammersley_in_whole_numbers
