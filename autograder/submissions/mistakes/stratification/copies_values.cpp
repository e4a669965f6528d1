// mistake: copies random values over each other in place of swapping them
// caught by: 3.4 every permutation is equally likely
// caught by: 3.4 permutations of many values have no trend
// caught by: 3.4 shuffle keeps every value
// hint: it does not copy one over another
#include "stratification.hpp"

#include <random>

#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& rng) {
  const std::vector<double> from(x.begin(), x.end());
  for (double& value : x) value = from[rng() % from.size()];
}

}  // namespace mc
