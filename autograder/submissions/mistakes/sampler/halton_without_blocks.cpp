// mistake: hands out 32 dimensions; beyond them each use is the first one or two again, shuffled
// caught by: 6.3 halton begins anew after eight dimensions
// caught by: 6.3 each of the first twenty next2 gains
// hint: these are dimensions 8 to 15
// hint: high dimensions of a sequence are poor pairs
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

constexpr std::size_t dimensions = joe_kuo.size();

void fill(std::size_t dimension, std::span<double> x, Rng& rng) {
  static const std::vector<unsigned> bases = primes(dimensions);
  if (dimension > 0) return radical_inverses_scrambled(bases[dimension], 0, x, rng());
  radical_inverses(2, 0, x);
  owen_scramble(x, rng());
}
void one(const Use& use, std::span<double> x, Rng& rng) {
  if (use.dimension < dimensions) return fill(use.dimension, x, rng);
  fill(0, x, rng);
  shuffle(x, rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  const bool padded = use.dimension + 2 > dimensions;
  fill(padded ? 0 : use.dimension, x, rng);
  fill(padded ? 1 : use.dimension + 1, y, rng);
  if (!padded) return;
  Rng again = rng;
  shuffle(x, rng);
  shuffle(y, again);
}

constexpr Kind wrong{"halton", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
