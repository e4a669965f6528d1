// mistake: a shuffle that chooses by 16 random bits, of which 100,000 values want more
// caught by: 3.4 permutations of many values have no trend
// hint: of which 16 are too few here
#include "stratification.hpp"
#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& rng) {
  for (std::size_t n = x.size(); n > 1; --n) std::swap(x[n - 1], x[(rng() & 0xffff) % n]);
}

}  // namespace mc
