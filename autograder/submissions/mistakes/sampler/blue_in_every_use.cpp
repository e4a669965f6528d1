// mistake: every next2() is blue noise
// caught by: 6.7 all else of blue_noise is stratified
// hint: each cell (i, j) gets one point
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void blue(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  best_candidate(x, y, 1, rng);
  if (use.number == 0) return;
  Rng again = rng;
  shuffle(x, rng);
  shuffle(y, again);
}

constexpr Kind wrong{"blue_noise", stratified1, blue};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
