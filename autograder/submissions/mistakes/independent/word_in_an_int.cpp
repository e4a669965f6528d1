// mistake: keeps the lower 32 bits of a word
// caught by: 2.1 the upper 53 bits
// hint: these are the lower 32 bits
#include "independent.hpp"

#define to_unit right_to_unit
#include "solutions/independent.cpp"
#undef to_unit

namespace mc {

double to_unit(std::uint64_t bits) {
  return static_cast<std::uint32_t>(bits) * 0x1p-32;
}

}  // namespace mc
