// mistake: a Poisson-disk pattern of too many points, of which any N are taken
// caught by: 6.7 the first next2 is blue noise
// hint: less than 0.13
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

/// A fifth more points than there should be, in random order, of which the first N are kept.
void cut(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.number > 0) return stratified2(use, x, y, rng);
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

constexpr Kind wrong{"blue_noise", stratified1, cut};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
