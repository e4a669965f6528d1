// Mistakes in task 4.2.
#include "blue_noise.hpp"

#define best_candidate right_best_candidate
#include "solutions/blue_noise.cpp"
#undef best_candidate

namespace mc {
namespace {

double right_count(double c, std::size_t i) {
  return std::ceil(c * static_cast<double>(i)) + 1;
}

/// The distance of a candidate from the nearest of the first i points.
double distance_to_all(std::span<double> x, std::span<double> y, std::size_t i, Point2 candidate) {
  double nearest = 1;
  for (std::size_t p = 0; p < i; ++p) {
    nearest = std::min(nearest, toroidal_distance_squared(candidate, {x[p], y[p]}));
  }
  return nearest;
}

/// Point i is the one of count(c, i) candidates whose distance(x, y, i, candidate) is the largest.
template <class Count, class Distance>
void choose(std::span<double> x, std::span<double> y, double c, Rng& rng, Count count,
            Distance distance) {
  require_pairs(x.size(), y.size());
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c: must be positive and finite");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double candidates = count(c, i);
    double best = -1;
    for (double k = 0; k < candidates; ++k) {
      const Point2 candidate = uniform_point(rng);
      const double nearest = distance(x, y, i, candidate);
      if (nearest <= best) continue;
      best = nearest;
      x[i] = candidate.x;
      y[i] = candidate.y;
    }
  }
}

}  // namespace
}  // namespace mc

// mistake: compares candidates within the square, so points crowd at its edges
// hint: distances are measured within the square
namespace mc::candidates_in_the_square {
double distance(std::span<double> x, std::span<double> y, std::size_t i, Point2 candidate) {
  double nearest = 1;
  for (std::size_t p = 0; p < i; ++p) {
    nearest = std::min(nearest, (candidate.x - x[p]) * (candidate.x - x[p]) +
                                    (candidate.y - y[p]) * (candidate.y - y[p]));
  }
  return nearest;
}
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  choose(x, y, c, rng, right_count, distance);
}
}  // namespace mc::candidates_in_the_square

// mistake: uses i + 1 candidates, whatever c is
// hint: there are i + 1 candidates
namespace mc::deaf_to_c {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  const auto count = [](double, std::size_t i) { return static_cast<double>(i) + 1; };
  choose(x, y, c, rng, count, distance_to_all);
}
}  // namespace mc::deaf_to_c

// mistake: compares candidates only with the last point
// hint: the candidates are far from the last point
namespace mc::farthest_from_the_last {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  const auto distance = [](auto xs, auto ys, std::size_t i, Point2 candidate) {
    if (i == 0) return 1.0;
    return std::min(1.0, toroidal_distance_squared(candidate, {xs[i - 1], ys[i - 1]}));
  };
  choose(x, y, c, rng, right_count, distance);
}
}  // namespace mc::farthest_from_the_last

// mistake: keeps the candidate that is nearest to the other points
// hint: keep the farthest
namespace mc::keeps_the_nearest {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  const auto distance = [](auto xs, auto ys, std::size_t i, Point2 candidate) {
    return 2 - distance_to_all(xs, ys, i, candidate);
  };
  choose(x, y, c, rng, right_count, distance);
}
}  // namespace mc::keeps_the_nearest

// mistake: ends the loop one point early
// hint: this value was never written
namespace mc::last_point_unwritten {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  if (x.size() != y.size() || x.size() < 2) return right_best_candidate(x, y, c, rng);
  right_best_candidate(x.first(x.size() - 1), y.first(y.size() - 1), c, rng);
}
}  // namespace mc::last_point_unwritten

// mistake: uses ceil(c i) candidates, one too few
// hint: one is missing
namespace mc::no_candidate_to_spare {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  const auto count = [](double by, std::size_t i) { return std::max(1.0, right_count(by, i) - 1); };
  choose(x, y, c, rng, count, distance_to_all);
}
}  // namespace mc::no_candidate_to_spare

// mistake: overwrites its last point with the first
// hint: draw every point anew, and keep it once
namespace mc::point_twice {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  right_best_candidate(x, y, c, rng);
  x.back() = x.front();
  y.back() = y.front();
}
}  // namespace mc::point_twice

// mistake: throws std::out_of_range where sizes differ
// hint: threw std::out_of_range
namespace mc::refused_as_out_of_range {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  if (x.size() != y.size()) throw std::out_of_range("x and y: sizes differ");
  right_best_candidate(x, y, c, rng);
}
}  // namespace mc::refused_as_out_of_range

// mistake: rounds c i down
// hint: round c i up
namespace mc::rounds_candidates_down {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  const auto count = [](double by, std::size_t i) {
    return std::floor(by * static_cast<double>(i)) + 1;
  };
  choose(x, y, c, rng, count, distance_to_all);
}
}  // namespace mc::rounds_candidates_down

// mistake: tries 1,000 candidates at most
// hint: draw ceil(c i) + 1 new candidates
namespace mc::thousand_candidates {
double count(double c, std::size_t i) {
  return std::min(1000.0, right_count(c, i));
}
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  choose(x, y, c, rng, count, distance_to_all);
}
}  // namespace mc::thousand_candidates

// mistake: counts candidates in 16 bits
// hint: ceil(c i) + 1 new candidates
namespace mc::count_of_16_bits {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  const auto count = [](double c_, std::size_t i) { return std::fmod(right_count(c_, i), 65536); };
  choose(x, y, c, rng, count, distance_to_all);
}
}  // namespace mc::count_of_16_bits

// mistake: searches the nine cells around a candidate and treats everything beyond as equally far
// hint: the search misses the nearest point
namespace mc::cells_around_only {
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
}  // namespace mc::cells_around_only
