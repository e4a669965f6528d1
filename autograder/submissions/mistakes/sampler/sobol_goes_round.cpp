// mistake: begins with the first dimension again after the eighth, in the same order
// caught by: 6.3 sobol begins anew after eight dimensions
// hint: every block but the first needs a shuffle
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void one(const Use& use, std::span<double> x, Rng& rng) {
  fill_sobol(use.dimension % block, x, rng(), use.tables);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  fill_sobol(use.dimension % block, x, rng(), use.tables);
  fill_sobol(use.dimension % block + 1, y, rng(), use.tables);
}

constexpr Kind wrong{"sobol", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
