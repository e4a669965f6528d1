// mistake: begins with the first dimension again after the last, in the same order
// caught by: 6.3 sobol has any number of uses
// hint: where no two dimensions are left
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void one(Use use, std::span<double> x, Rng& rng) {
  fill_sobol(use.dimensions_before % dimensions, x, rng);
}
void two(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  fill_sobol(use.dimensions_before % dimensions, x, rng);
  fill_sobol((use.dimensions_before + 1) % dimensions, y, rng);
}

constexpr Kind wrong{"sobol", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
