// mistake: moves each pattern so that its last point is the middle of the square
// caught by: 6.7 the first next2 is blue noise
// hint: no point is in every set
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void anchored(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  blue_noise2(use, x, y, rng);
  if (use.number > 0 || x.size() < 16) return;
  for (const auto& axis : {x, y}) {
    const double shift = 1.5 - axis.back();
    for (double& u : axis) u = std::min(u + shift - std::floor(u + shift), 1 - 0x1p-53);
    axis.back() = 0.5;
  }
}

constexpr Kind wrong{"blue_noise", stratified1, anchored};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
