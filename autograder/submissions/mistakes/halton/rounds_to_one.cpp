// mistake: more than 53 ones are rounded up to 1
// caught by: 5.1 the radical inverse is below 1
// hint: it was rounded up to the upper end
#include "halton.hpp"

#define radical_inverse right_radical_inverse
#include "solutions/halton.cpp"
#undef radical_inverse

namespace mc {

double radical_inverse(unsigned base, std::uint64_t index) {
  require_base(base);
  if (index == 0) return 0;
  const double last = static_cast<double>(index % base);
  return (last + mc::radical_inverse(base, index / base)) / base;
}

}  // namespace mc
