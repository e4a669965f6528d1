// mistake: the second axis of a next2() is the first dimension of the next use
// caught by: 6.3 the uses of halton are Halton dimensions
// hint: each new use takes the next ones
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void one(Use use, std::span<double> x, Rng& rng) {
  one_of<fill_halton>({use.number, use.dimensions_before - use.dimensions_before / 3}, x, rng);
}
void two(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  two_of<fill_halton>({use.number, use.dimensions_before - use.dimensions_before / 3}, x, y, rng);
}

constexpr Kind wrong{"halton", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
