// mistake: the first index of Halton points is kept in 32 bits
// caught by: 5.3 Halton points
// hint: `first` has 64 bits, of which 32 were kept
#include "halton.hpp"

#define halton right_halton
#include "solutions/halton.cpp"
#undef halton

namespace mc {

void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size(), last_index);
  right_halton(points, static_cast<std::uint32_t>(first));
}

}  // namespace mc
