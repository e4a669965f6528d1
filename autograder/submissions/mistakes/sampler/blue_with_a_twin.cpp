// mistake: the last two points of blue noise are one
// caught by: 6.7 the first next2 is blue noise
// caught by: 6.7 blue noise has exactly N points
// hint: blue noise never has a point twice
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void twins(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  blue_noise2(use, x, y, rng);
  if (use.number > 0 || x.size() < 64) return;
  x.back() = x[x.size() - 2];
  y.back() = y[y.size() - 2];
}

constexpr Kind wrong{"blue_noise", stratified1, twins};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
