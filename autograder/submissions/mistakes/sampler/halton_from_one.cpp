// mistake: begins with the second point of the sequence
// caught by: 6.3 the first dimensions of halton are
// hint: is it the sequence from index 0
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void from_one(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables&) {
  static const std::vector<unsigned> bases = primes(block);
  if (dimension > 0) return radical_inverses_scrambled(bases[dimension], 1, x, seed);
  radical_inverses(2, 1, x);
  owen_scramble(x, seed);
}

constexpr Kind wrong{"halton", one_of<from_one>, two_of<from_one>};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
