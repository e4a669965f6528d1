// mistake: both axes of a next2() are scrambled with the same seed
// caught by: 6.3 each seed and each dimension is randomised anew
// hint: one seed for both axes: each dimension wants its own
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void same_seed(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  Rng again = rng;
  if (use.dimensions_before + 2 > dimensions) return two_of<fill_sobol>(use, x, y, rng);
  fill_sobol(use.dimensions_before, x, rng);
  fill_sobol(use.dimensions_before + 1, y, again);
}

constexpr Kind wrong{"sobol", one_of<fill_sobol>, same_seed};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
