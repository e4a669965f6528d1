// mistake: divides by 2^53 - 1: uniform over [0, 1], both ends included
// caught by: 2.1 the upper 53 bits
// caught by: 2.1 no word becomes one
// hint: dividing by 2^53 - 1 makes 1 a possible number
#include "independent.hpp"

#define to_unit right_to_unit
#include "solutions/independent.cpp"
#undef to_unit

namespace mc {

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) / (0x1p53 - 1);
}

}  // namespace mc
