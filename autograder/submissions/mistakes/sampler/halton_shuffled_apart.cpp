// mistake: beyond the first eight dimensions each column has an order of its own
// caught by: 6.3 halton begins anew after eight dimensions
// caught by: 6.3 each of the first twenty next2 gains
// hint: all dimensions of a block share one permutation
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

template <Randomised fill>
void own_order(const Use& use, std::size_t dimension, std::span<double> x, Rng& rng) {
  fill(dimension % block, x, rng(), use.tables);
  if (dimension >= block) shuffle(x, rng);
}
void one(const Use& use, std::span<double> x, Rng& rng) {
  own_order<fill_halton>(use, use.dimension, x, rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  own_order<fill_halton>(use, use.dimension, x, rng);
  own_order<fill_halton>(use, use.dimension + 1, y, rng);
}

constexpr Kind wrong{"halton", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
