// mistake: permutes the digits of base 2 too, which is a digital shift
// caught by: 6.3 the first dimensions of halton are
// hint: a digital shift
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void permuted(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables&) {
  static const std::vector<unsigned> bases = primes(block);
  radical_inverses_scrambled(bases[dimension], 0, x, seed);
}

constexpr Kind wrong{"halton", one_of<permuted>, two_of<permuted>};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
