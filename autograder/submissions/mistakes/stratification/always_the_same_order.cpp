// mistake: shuffles by a generator of its own, always with the same seed
// caught by: 3.4 every permutation is equally likely
// caught by: 3.4 permutations of many values have no trend
// caught by: 3.4 shuffle keeps every value
// hint: draw it from the generator that is passed in
#include "stratification.hpp"

#include <random>

#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& /*rng*/) {
  std::mt19937 mine;
  std::shuffle(x.begin(), x.end(), mine);
}

}  // namespace mc
