// mistake: (i + 1/2)/N along the first axis
// caught by: 5.4 Hammersley
// caught by: 5.4 integrals
// hint: this is the centred variant
#include "halton.hpp"

#define hammersley right_hammersley
#include "solutions/halton.cpp"
#undef hammersley

namespace mc {

void hammersley(PointSet& points) {
  right_hammersley(points);
  for (double& x : points.column(0)) x += 0.5 / static_cast<double>(points.size());
}

}  // namespace mc
