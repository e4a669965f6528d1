// mistake: looks at the nine cells around a candidate and calls everything beyond equally far
// caught by: 4.7 thousands of best candidates
// hint: near points are missed
#include "blue_noise.hpp"
#define best_candidate right_best_candidate
#include "solutions/blue_noise.cpp"
#undef best_candidate

namespace mc {

// Up to 256 points it compares with all. From there on it knows cells of a fixed grid, too fine.
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  const std::size_t plain = std::min<std::size_t>(x.size(), 256);
  if (x.size() != y.size() || x.size() <= plain) return right_best_candidate(x, y, c, rng);
  right_best_candidate(x.first(plain), y.first(plain), c, rng);
  constexpr std::size_t side = 64;
  std::vector<std::vector<std::size_t>> cells(side * side);
  const auto cell = [](double at) { return static_cast<std::size_t>(at * side); };
  for (std::size_t p = 0; p < plain; ++p) cells[cell(y[p]) * side + cell(x[p])].push_back(p);
  for (std::size_t i = plain; i < x.size(); ++i) {
    const double candidates = std::ceil(c * static_cast<double>(i)) + 1;
    double farthest = -1;
    for (double k = 0; k < candidates; ++k) {
      const Point2 candidate = uniform_point(rng);
      double nearest = 1;
      for (std::size_t dj = side - 1; dj <= side + 1; ++dj) {
        for (std::size_t di = side - 1; di <= side + 1; ++di) {
          const std::size_t row = (cell(candidate.y) + dj) % side;
          for (const std::size_t p : cells[row * side + (cell(candidate.x) + di) % side]) {
            nearest = std::min(nearest, toroidal_distance_squared(candidate, {x[p], y[p]}));
          }
        }
      }
      if (nearest > farthest) {
        farthest = nearest;
        x[i] = candidate.x;
        y[i] = candidate.y;
      }
    }
    cells[cell(y[i]) * side + cell(x[i])].push_back(i);
  }
}

}  // namespace mc
