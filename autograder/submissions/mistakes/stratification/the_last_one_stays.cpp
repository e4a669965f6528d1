// mistake: a loop that ends one too early: the last value never moves
// caught by: 3.4 every permutation is equally likely
// hint: never moves
#include "stratification.hpp"
#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& rng) {
  if (x.size() > 1) right_shuffle(x.first(x.size() - 1), rng);
}

}  // namespace mc
