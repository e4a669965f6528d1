// mistake: throws std::out_of_range where sizes differ
// caught by: 4.2 misuse of best_candidate
// caught by: 4.2 a refusal names the argument
// hint: threw std::out_of_range
#include "blue_noise.hpp"
#define best_candidate right_best_candidate
#include "solutions/blue_noise.cpp"
#undef best_candidate

namespace mc {

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  if (x.size() != y.size()) throw std::out_of_range("x and y: sizes differ");
  right_best_candidate(x, y, c, rng);
}

}  // namespace mc
