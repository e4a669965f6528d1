// mistake: fills whole blocks of four Sobol' coordinates, and forgets the rest
// caught by: 5.5 a column of Sobol
// hint: this value was never written
#include "halton.hpp"

#define sobol right_sobol
#include "solutions/halton.cpp"
#undef sobol

namespace mc {

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  const auto rest = column.last(column.size() % 4);
  const std::vector<double> before(rest.begin(), rest.end());
  right_sobol(dimension, first, column);
  std::copy(before.begin(), before.end(), rest.begin());
}

}  // namespace mc
