// mistake: all blocks but the first have the same order
// caught by: 6.3 sobol begins anew after eight dimensions
// hint: each block needs a random permutation of its own
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

template <Randomised fill>
void same_order(const Use& use, std::size_t dimension, std::span<double> x, Rng& rng) {
  fill(dimension % block, x, rng(), use.tables);
  Rng always(x.size());
  if (dimension >= block) shuffle(x, always);
}
void one(const Use& use, std::span<double> x, Rng& rng) {
  same_order<fill_sobol>(use, use.dimension, x, rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  same_order<fill_sobol>(use, use.dimension, x, rng);
  same_order<fill_sobol>(use, use.dimension + 1, y, rng);
}

constexpr Kind wrong{"sobol", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
