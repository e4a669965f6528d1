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

#define BEST_CANDIDATE(count, distance)                                               \
  void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) { \
    choose(x, y, c, rng, count, distance);                                            \
  }

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
BEST_CANDIDATE(right_count, distance)
}  // namespace mc::candidates_in_the_square

// mistake: uses i + 1 candidates, whatever c is
// hint: there are i + 1 candidates
namespace mc::deaf_to_c {
double count(double, std::size_t i) {
  return static_cast<double>(i) + 1;
}
BEST_CANDIDATE(count, distance_to_all)
}  // namespace mc::deaf_to_c

// mistake: compares candidates only with the last point
// hint: the candidates are far from the last point
namespace mc::farthest_from_the_last {
double distance(std::span<double> x, std::span<double> y, std::size_t i, Point2 candidate) {
  return i == 0 ? 1 : toroidal_distance_squared(candidate, {x[i - 1], y[i - 1]});
}
BEST_CANDIDATE(right_count, distance)
}  // namespace mc::farthest_from_the_last

// mistake: keeps the candidate that is nearest to the other points
// hint: keep the farthest
namespace mc::keeps_the_nearest {
double distance(std::span<double> x, std::span<double> y, std::size_t i, Point2 candidate) {
  return 2 - distance_to_all(x, y, i, candidate);
}
BEST_CANDIDATE(right_count, distance)
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
double count(double c, std::size_t i) {
  return std::max(1.0, right_count(c, i) - 1);
}
BEST_CANDIDATE(count, distance_to_all)
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
double count(double c, std::size_t i) {
  return std::floor(c * static_cast<double>(i)) + 1;
}
BEST_CANDIDATE(count, distance_to_all)
}  // namespace mc::rounds_candidates_down

// mistake: counts from 0 to ceil(c i) + 1, one candidate too many
// hint: there is one candidate too many
namespace mc::one_candidate_more {
double count(double c, std::size_t i) {
  return right_count(c, i) + 1;
}
BEST_CANDIDATE(count, distance_to_all)
}  // namespace mc::one_candidate_more

// mistake: does not reset the nearest distance for the next candidate, so the first one wins
// hint: as irregular as uniform points: keep the farthest of several candidates
namespace mc::nearest_never_reset {
BEST_CANDIDATE(right_count, ([nearest = 1.0, point = std::size_t{0}](auto x, auto y, std::size_t i,
                                                                     Point2 candidate) mutable {
                 if (std::exchange(point, i) != i) nearest = 1;
                 return nearest = std::min(nearest, distance_to_all(x, y, i, candidate));
               }))
}  // namespace mc::nearest_never_reset

// mistake: stores coordinates as floats
// hint: use no float
namespace mc::float_coordinates {
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  right_best_candidate(x, y, c, rng);
  for (const auto& axis : {x, y}) {
    for (double& value : axis) value = std::min(static_cast<float>(value), 0x1.fffffep-1f);
  }
}
}  // namespace mc::float_coordinates

// mistake: counts candidates in 16 bits
// hint: some are missing or not new
namespace mc::count_of_16_bits {
double count(double c, std::size_t i) {
  return std::fmod(right_count(c, i), 65536);
}
BEST_CANDIDATE(count, distance_to_all)
}  // namespace mc::count_of_16_bits

// mistake: searches the nine cells around a candidate and treats everything beyond as equally far
// hint: the search misses the nearest point
namespace mc::cells_around_only {
// From 256 points on it knows only the cells of a grid that is too fine.
double distance(std::span<double> x, std::span<double> y, std::size_t i, Point2 candidate) {
  if (i < 256) return distance_to_all(x, y, i, candidate);
  const auto cells_apart = [](double a, double b) {
    const double apart = std::abs(std::floor(64 * a) - std::floor(64 * b));
    return std::min(apart, 64 - apart);
  };
  double nearest = 1;
  for (std::size_t p = 0; p < i; ++p) {
    if (cells_apart(x[p], candidate.x) > 1 || cells_apart(y[p], candidate.y) > 1) continue;
    nearest = std::min(nearest, toroidal_distance_squared(candidate, {x[p], y[p]}));
  }
  return nearest;
}
BEST_CANDIDATE(right_count, distance)
}  // namespace mc::cells_around_only
