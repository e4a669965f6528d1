// mistake: all 64 bits are divided by 2^64: the largest words round up to 1
// caught by: 2.1 the upper 53 bits
// caught by: 2.1 no word becomes one
// hint: a word has 64 bits and a double 53
#include "independent.hpp"

#define to_unit right_to_unit
#include "solutions/independent.cpp"
#undef to_unit

namespace mc {

double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits) * 0x1p-64;
}

}  // namespace mc
