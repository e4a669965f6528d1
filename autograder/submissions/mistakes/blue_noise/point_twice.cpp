// mistake: writes its last point over again, from the first one
// caught by: 4.2 each point is the best of its candidates
// caught by: 4.2 best candidates are blue
// hint: every point is drawn anew, and kept once
#include "blue_noise.hpp"
#define best_candidate right_best_candidate
#include "solutions/blue_noise.cpp"
#undef best_candidate

namespace mc {

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  right_best_candidate(x, y, c, rng);
  x.back() = x.front();
  y.back() = y.front();
}

}  // namespace mc
