// mistake: every axis is in base 2
// caught by: 5.3 Halton points
// caught by: 5.3 integrals
// caught by: 5.3 each elementary interval
// hint: this axis is in base 2
#include "halton.hpp"

#define halton right_halton
#include "solutions/halton.cpp"
#undef halton

namespace mc {

void halton(PointSet& points, std::uint64_t first) {
  for (std::size_t d = 0; d < points.dims(); ++d) radical_inverses(2, first, points.column(d));
}

}  // namespace mc
