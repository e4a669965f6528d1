// Mistakes in task 2.1.
#include "independent.hpp"

#define to_unit right_to_unit
#include "solutions/independent.cpp"
#undef to_unit

// mistake: divides by 2^53 - 1: uniform over [0, 1], both ends included
// hint: dividing by 2^53 - 1 makes 1 a possible result
namespace mc::closed_interval {
double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) / (0x1p53 - 1);
}
}  // namespace mc::closed_interval

// mistake: divides all 64 bits by 2^64: the largest words round up to 1
// hint: a word has 64 bits and a double 53
namespace mc::rounds_to_one {
double to_unit(std::uint64_t bits) {
  return static_cast<double>(bits) * 0x1p-64;
}
}  // namespace mc::rounds_to_one

// mistake: keeps only the lower 32 bits of a word
// hint: these are the lower 32 bits
namespace mc::word_in_an_int {
double to_unit(std::uint64_t bits) {
  return static_cast<std::uint32_t>(bits) * 0x1p-32;
}
}  // namespace mc::word_in_an_int
