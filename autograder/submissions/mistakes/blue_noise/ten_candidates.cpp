// mistake: has ten candidates for every point
// fails: 4.2
// hint: the number of candidates hardly grows
#include "blue_noise.hpp"
#define best_candidate right_best_candidate
#include "solutions/blue_noise.cpp"
#undef best_candidate

namespace mc {

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: must be positive and finite");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double candidates = c > 0 ? 10 : 0;
    double best = -1;
    for (double k = 0; k < candidates; ++k) {
      const Point2 candidate = uniform_point(rng);
      double nearest = 1;
      for (std::size_t p = 0; p < i; ++p) {
        nearest = std::min(nearest, toroidal_distance_squared(candidate, {x[p], y[p]}));
      }
      if (nearest > best) {
        best = nearest;
        x[i] = candidate.x;
        y[i] = candidate.y;
      }
    }
  }
}

}  // namespace mc
