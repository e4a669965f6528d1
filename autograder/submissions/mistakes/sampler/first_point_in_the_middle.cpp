// mistake: the first point of blue noise is the middle of the square
// caught by: 6.4 neighbouring seeds have nothing in common
// caught by: 6.7 the first next2 is blue noise
// hint: does every pattern begin at the same place?
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void centred(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.number > 0) return stratified2(use, x, y, rng);
  best_candidate(x, y, 1, rng);
  for (const auto& axis : {x, y}) {
    const double shift = 1.5 - axis[0];
    for (double& u : axis) u = std::min(u + shift - std::floor(u + shift), 1 - 0x1p-53);
  }
}

constexpr Kind wrong{"blue_noise", stratified1, centred};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
