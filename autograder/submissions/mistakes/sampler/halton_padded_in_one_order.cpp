// mistake: all uses beyond the last dimension have the same order
// caught by: 6.3 halton has any number of uses
// hint: one dimension twice in the same order is one number for two uses
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void same_order(std::span<double> x) {
  Rng always(x.size());
  shuffle(x, always);
}
void one(Use use, std::span<double> x, Rng& rng) {
  if (use.dimensions_before < dimensions) return one_of<fill_halton>(use, x, rng);
  fill_halton(0, x, rng);
  same_order(x);
}
void two(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.dimensions_before + 2 <= dimensions) return two_of<fill_halton>(use, x, y, rng);
  fill_halton(0, x, rng);
  fill_halton(1, y, rng);
  same_order(x);
  same_order(y);
}

constexpr Kind wrong{"halton", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
