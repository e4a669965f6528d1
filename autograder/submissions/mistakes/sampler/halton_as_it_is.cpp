// mistake: does not permute the digits of the Halton sequence
// caught by: 6.3 each of the first twenty next2 gains
// caught by: 6.3 each seed and each dimension is randomised anew
// caught by: 6.3 halton begins anew after eight dimensions
// hint: a sequence as it is has the origin for its first point
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void plain(std::size_t dimension, std::span<double> x, std::uint64_t, Tables&) {
  radical_inverses(primes(block)[dimension], 0, x);
}

constexpr Kind wrong{"halton", one_of<plain>, two_of<plain>};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
