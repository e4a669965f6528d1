// mistake: counts in a float, which 1 no longer changes from 2^24 on
// caught by: 1.4 one more value after very many
// caught by: 1.4 Welford survives a stream
// hint: a float counts to 2^24 only
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  const float count = static_cast<float>(moments.count) + 1;
  const double before = x - moments.mean;
  moments.count = static_cast<std::uint64_t>(count);
  moments.mean += before / count;
  moments.m2 += before * (x - moments.mean);
}

}  // namespace mc
