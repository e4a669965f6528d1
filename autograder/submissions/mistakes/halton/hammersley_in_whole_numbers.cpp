// mistake: divides i by N as whole numbers, which gives 0
// caught by: 5.4 Hammersley
// caught by: 5.4 integrals
// hint: i / N of two whole numbers is 0
#include "halton.hpp"

#define hammersley right_hammersley
#include "solutions/halton.cpp"
#undef hammersley

namespace mc {

void hammersley(PointSet& points) {
  right_hammersley(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points.column(0)[i] = static_cast<double>(i / points.size());
  }
}

}  // namespace mc
