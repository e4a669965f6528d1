// mistake: each value changes places with a later one, never with itself
// caught by: 3.4 every permutation is equally likely
// hint: let it change places with itself too
#include "stratification.hpp"

#include <random>

#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& rng) {
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    std::swap(x[i], x[i + 1 + rng() % (x.size() - i - 1)]);
  }
}

}  // namespace mc
