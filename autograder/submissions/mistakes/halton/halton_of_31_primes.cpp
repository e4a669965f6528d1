// mistake: primes from a table of 31, which begins anew behind its end
// caught by: 5.3 Halton points
// hint: this axis is in base 2
#include "halton.hpp"

#define halton right_halton
#include "solutions/halton.cpp"
#undef halton

namespace mc {

void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size(), last_index);
  const auto table = primes(31);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    radical_inverses(table[d % table.size()], first, points.column(d));
  }
}

}  // namespace mc
