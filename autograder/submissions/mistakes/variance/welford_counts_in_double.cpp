// mistake: adds 1 to a count that is a double, which no longer changes from 2^53 on
// caught by: 1.4 one more value after very many
// hint: a double counts to 2^53 only
#include "variance.hpp"
#define add right_add
#include "solutions/variance.cpp"
#undef add

namespace mc {

void add(Moments& moments, double x) {
  const double count = static_cast<double>(moments.count) + 1;
  moments.count = static_cast<std::uint64_t>(count);
  const double before = x - moments.mean;
  moments.mean += before / count;
  moments.m2 += before * (x - moments.mean);
}

}  // namespace mc
