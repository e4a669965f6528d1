// mistake: shuffles blocks of 128 values, each by itself
// caught by: 3.4 permutations of many values have no trend
// hint: each value may go anywhere
#include "stratification.hpp"
#define shuffle right_shuffle
#include "solutions/stratification.cpp"
#undef shuffle

namespace mc {

void shuffle(std::span<double> x, Rng& rng) {
  for (std::size_t first = 0; first < x.size(); first += 128) {
    right_shuffle(x.subspan(first, std::min<std::size_t>(128, x.size() - first)), rng);
  }
}

}  // namespace mc
