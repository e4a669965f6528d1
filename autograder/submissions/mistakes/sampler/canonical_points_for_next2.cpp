// mistake: shuffles next(), and leaves the points of next2() in the order of their cells
// caught by: 6.2 each sample dimension has a permutation of its own
// hint: the pattern must be shuffled
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void in_order(const Use&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
}
constexpr Kind wrong{"stratified", stratified1, in_order};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
