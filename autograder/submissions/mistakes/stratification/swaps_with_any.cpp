// mistake: each value changes places with any of the n, which favours some orders
// caught by: 3.4 every permutation is equally likely
// caught by: 3.4 permutations of many values have no trend
// hint: each value changes places with any of the n
#include "stratification.hpp"

#include <random>

#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& rng) {
  for (double& value : x) std::swap(value, x[rng() % x.size()]);
}

}  // namespace mc
