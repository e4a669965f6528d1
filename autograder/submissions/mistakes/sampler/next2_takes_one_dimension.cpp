// mistake: the second axis of a next2() is the first dimension of the next use
// caught by: 6.3 the first dimensions of halton are
// caught by: 6.3 halton begins anew after eight dimensions
// caught by: 6.3 each of the first twenty
// hint: takes the next one of the sequence
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void one(const Use& use, std::span<double> x, Rng& rng) {
  one_of<fill_halton>({use.number, use.dimension - use.dimension / 3, use.order, use.tables}, x,
                      rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  two_of<fill_halton>({use.number, use.dimension - use.dimension / 3, use.order, use.tables}, x, y,
                      rng);
}

constexpr Kind wrong{"halton", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
