// mistake: shuffles x and y of a multi-jittered pattern apart
// caught by: 6.2 next2 has one point in each cell
// hint: shuffled apart: pairs stay together
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void apart(const Use&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
  shuffle(x, rng);
  shuffle(y, rng);
}

constexpr Kind wrong{"stratified", stratified1, apart};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
