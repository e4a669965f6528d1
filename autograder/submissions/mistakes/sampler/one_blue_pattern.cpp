// mistake: blue noise is slow, so one pattern is kept for all seeds
// caught by: 6.4 neighbouring seeds have nothing in common
// caught by: 6.7 the first next2 is blue noise
// hint: does this number depend on the seed at all?
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void kept(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.number > 0) return stratified2(use, x, y, rng);
  Rng always(x.size());
  best_candidate(x, y, 1, always);
}

constexpr Kind wrong{"blue_noise", stratified1, kept};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
