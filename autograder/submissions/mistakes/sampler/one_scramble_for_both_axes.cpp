// mistake: both axes of a next2() are scrambled with the same seed
// caught by: 6.3 each seed and each dimension is randomised anew
// hint: one seed for several dimensions: each needs its own
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void same_seed(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  Rng again = rng;
  fill_in_order<fill_sobol>(use, use.dimension, x, rng);
  fill_in_order<fill_sobol>(use, use.dimension + 1, y, again);
}

constexpr Kind wrong{"sobol", one_of<fill_sobol>, same_seed};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
