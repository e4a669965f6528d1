// Mistakes in task 6.7.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

// mistake: makes every next2() blue noise
// hint: each cell (i, j) gets one point
namespace mc::blue_in_every_use {
void blue(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  best_candidate(x, y, 1, rng);
  if (dim.number == 0) return;
  Rng again = rng;
  shuffle(x, rng);
  shuffle(y, again);
}

MAKE_SAMPLER(make_other_kind<stratified1, blue>("blue_noise", kind))
}  // namespace mc::blue_in_every_use

// mistake: shuffles x and y of a blue-noise pattern separately
// hint: together
namespace mc::blue_shuffled_apart {
void apart(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  blue_noise(dim, x, y, rng);
  if (dim.number == 0) shuffle(y, rng);
}

MAKE_SAMPLER(make_other_kind<stratified1, apart>("blue_noise", kind))
}  // namespace mc::blue_shuffled_apart

// mistake: uses blue noise only if a next2() is the very first request
// hint: the first next2(), also after a next(), must be lab 4's best_candidate()
namespace mc::blue_where_it_is_first {
void blue(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (dim.place > 0) return stratified(dim, x, y, rng);  // counts requests of both sorts
  best_candidate(x, y, 1, rng);
}

MAKE_SAMPLER(make_wrong<either<stratified1, blue>>("blue_noise", kind))
}  // namespace mc::blue_where_it_is_first

// mistake: makes the last two points of blue noise equal
// hint: use each point of the pattern once
namespace mc::blue_with_a_twin {
void twins(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  blue_noise(dim, x, y, rng);
  if (dim.number > 0 || x.size() < 64) return;
  x.back() = x[x.size() - 2];
  y.back() = y[y.size() - 2];
}

MAKE_SAMPLER(make_other_kind<stratified1, twins>("blue_noise", kind))
}  // namespace mc::blue_with_a_twin

// mistake: makes a Poisson-disk pattern of too many points, and keeps any N
// hint: less than 0.11
namespace mc::poisson_disk_cut {
/// A fifth more points than there should be, in random order, of which the first N are kept.
void cut(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (dim.number > 0) return stratified(dim, x, y, rng);
  PointSet points;
  double radius = 0.764 / std::sqrt(static_cast<double>(x.size()));
  do {
    points = poisson_disk(radius, rng);
    radius *= 0.95;
  } while (points.size() < x.size());
  Rng again = rng;
  shuffle(points.column(0), rng);
  shuffle(points.column(1), again);
  std::copy_n(points.column(0).begin(), x.size(), x.begin());
  std::copy_n(points.column(1).begin(), y.size(), y.begin());
}

MAKE_SAMPLER(make_other_kind<stratified1, cut>("blue_noise", kind))
}  // namespace mc::poisson_disk_cut

// mistake: uses ten candidates for each point, whatever their number
// hint: point i is the best of i + 1 candidates
namespace mc::ten_candidates {
void ten(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (dim.number > 0) return stratified(dim, x, y, rng);
  for (std::size_t i = 0; i < x.size(); ++i) {
    double farthest = -1;
    for (int candidate = 0; candidate < 10; ++candidate) {
      const Point2 p{to_unit(rng()), to_unit(rng())};
      double nearest = 1;
      for (std::size_t j = 0; j < i; ++j) {
        nearest = std::min(nearest, toroidal_distance_squared(p, {x[j], y[j]}));
      }
      if (nearest <= farthest) continue;
      farthest = nearest;
      x[i] = p.x;
      y[i] = p.y;
    }
  }
}

MAKE_SAMPLER(make_other_kind<stratified1, ten>("blue_noise", kind))
}  // namespace mc::ten_candidates

// mistake: shifts one pattern by a random vector
// hint: a pattern that is shifted is not a new one
namespace mc::one_pattern_shifted {
void shifted(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (dim.number > 0) return stratified(dim, x, y, rng);
  Rng always(x.size());
  best_candidate(x, y, 1, always);
  for (const auto& axis : {x, y}) {
    const double shift = to_unit(rng());
    for (double& u : axis) u = std::min(u + shift - std::floor(u + shift), 1 - 0x1p-53);
  }
}

MAKE_SAMPLER(make_other_kind<stratified1, shifted>("blue_noise", kind))
}  // namespace mc::one_pattern_shifted

// mistake: puts the first point of blue noise in the middle of the square
// fails: 6.4
// hint: in every set: draw it from the given generator
namespace mc::first_point_in_the_middle {
void centered(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (dim.number > 0) return stratified(dim, x, y, rng);
  best_candidate(x, y, 1, rng);
  for (const auto& axis : {x, y}) {
    const double shift = 1.5 - axis[0];
    for (double& u : axis) u = std::min(u + shift - std::floor(u + shift), 1 - 0x1p-53);
  }
}

MAKE_SAMPLER(make_other_kind<stratified1, centered>("blue_noise", kind))
}  // namespace mc::first_point_in_the_middle

// mistake: keeps one blue-noise pattern for all seeds
// fails: 6.4
// hint: keep none in a static variable
namespace mc::one_blue_pattern {
void kept(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (dim.number > 0) return stratified(dim, x, y, rng);
  Rng always(x.size());
  best_candidate(x, y, 1, always);
}

MAKE_SAMPLER(make_other_kind<stratified1, kept>("blue_noise", kind))
}  // namespace mc::one_blue_pattern

// mistake: makes blue noise for up to 1,024 samples, and stratified points for more
// hint: must be lab 4's best_candidate() with c = 1
namespace mc::blue_up_to_1024 {
void few(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  x.size() > 1024 ? stratified(dim, x, y, rng) : blue_noise(dim, x, y, rng);
}

MAKE_SAMPLER(make_other_kind<stratified1, few>("blue_noise", kind))
}  // namespace mc::blue_up_to_1024
