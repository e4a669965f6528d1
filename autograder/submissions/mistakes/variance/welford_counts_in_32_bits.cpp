// mistake: counts in an unsigned int, which is 0 again at 2^32
// caught by: 1.4 one more value after very many
// hint: 32 bits count to 2^32 only
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  const unsigned count = static_cast<unsigned>(moments.count) + 1;
  ++moments.count;
  const double before = x - moments.mean;
  moments.mean += before / count;
  moments.m2 += before * (x - moments.mean);
}

}  // namespace mc
