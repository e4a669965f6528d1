// mistake: adds the digits from the large end to the small, where every sum is rounded near 1
// caught by: 5.1 the last digit
// hint: add the smallest terms first
#include "halton.hpp"

#define radical_inverse right_radical_inverse
#include "solutions/halton.cpp"
#undef radical_inverse

namespace mc {

double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  double sum = 0, part = 1;
  for (; index > 0; index /= base) {
    part /= base;
    sum += part * static_cast<double>(index % base);
  }
  return std::min(below_one, sum);
}

}  // namespace mc
