// mistake: ten candidates for each point, however many there are
// caught by: 6.7 the first next2 is blue noise
// hint: as blue as a fixed number of candidates
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void ten(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.number > 0) return stratified2(use, x, y, rng);
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

constexpr Kind wrong{"blue_noise", stratified1, ten};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
