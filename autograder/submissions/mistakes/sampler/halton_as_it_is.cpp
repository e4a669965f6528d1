// mistake: does not permute the digits of the Halton sequence
// caught by: 6.3 each seed and each dimension is randomised anew
// caught by: 6.3 halton has any number of uses
// hint: a sequence as it is has the origin for its first point
#include "sampler.hpp"

namespace mc {
namespace {

void plain(unsigned base, std::uint64_t first, std::span<double> x, std::uint64_t) {
  radical_inverses(base, first, x);
}

}  // namespace
}  // namespace mc

#define radical_inverses_scrambled plain
#include "solutions/sampler.cpp"
