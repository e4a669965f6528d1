// mistake: throws where the sequence has no more dimensions
// caught by: 6.3 sobol begins anew after eight dimensions
// caught by: 6.3 each of the first twenty next2 gains
// hint: dimension: there are only 32
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void fill(std::size_t dimension, std::span<double> x, Rng& rng) {
  sobol(static_cast<unsigned>(dimension), 0, x);
  owen_scramble(x, rng());
}
void one(const Use& use, std::span<double> x, Rng& rng) {
  fill(use.dimension, x, rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  fill(use.dimension, x, rng);
  fill(use.dimension + 1, y, rng);
}

constexpr Kind wrong{"sobol", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
