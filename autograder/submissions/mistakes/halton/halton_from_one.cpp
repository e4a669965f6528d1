// mistake: the first Halton point is that of index first + 1
// caught by: 5.3 Halton points
// caught by: 5.3 integrals
// hint: this begins one index too late
#include "halton.hpp"

#define halton right_halton
#include "solutions/halton.cpp"
#undef halton

namespace mc {

void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size() + 1, last_index);
  right_halton(points, first + 1);
}

}  // namespace mc
