// mistake: shuffles x and y of a blue-noise pattern apart
// caught by: 6.7 the first next2 is blue noise
// hint: together
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void apart(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  blue_noise2(use, x, y, rng);
  if (use.number == 0) shuffle(y, rng);
}

constexpr Kind wrong{"blue_noise", stratified1, apart};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
