// mistake: its loop ends one point early
// caught by: 4.2 each point is the best of its candidates
// caught by: 4.2 best candidates are blue
// hint: this value was never written
#include "blue_noise.hpp"
#define best_candidate right_best_candidate
#include "solutions/blue_noise.cpp"
#undef best_candidate

namespace mc {

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  if (x.size() != y.size() || x.size() < 2) return right_best_candidate(x, y, c, rng);
  right_best_candidate(x.first(x.size() - 1), y.first(y.size() - 1), c, rng);
}

}  // namespace mc
