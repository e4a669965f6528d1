// mistake: blue noise only where a next2() is the very first use
// caught by: 6.7 the first next2 is blue noise
// hint: the first next2() is blue noise also where a next() comes before
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void blue(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.dimension > 0) return stratified2(use, x, y, rng);
  best_candidate(x, y, 1, rng);
}

constexpr Kind wrong{"blue_noise", stratified1, blue};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
