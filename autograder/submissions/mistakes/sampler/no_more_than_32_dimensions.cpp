// mistake: throws where no dimension is left
// caught by: 6.3 sobol has any number of uses
// hint: there are direction numbers for 32 of them
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void one(Use use, std::span<double> x, Rng& rng) {
  fill_sobol(use.dimensions_before, x, rng);
}
void two(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  fill_sobol(use.dimensions_before, x, rng);
  fill_sobol(use.dimensions_before + 1, y, rng);
}
constexpr Kind wrong{"sobol", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
