// mistake: where one dimension is left, a next2() takes that and the first
// caught by: 6.3 sobol has any number of uses
// hint: where no two dimensions are left
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void two(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.dimensions_before + 1 != dimensions) return two_of<fill_sobol>(use, x, y, rng);
  fill_sobol(dimensions - 1, x, rng);
  fill_sobol(0, y, rng);
}

constexpr Kind wrong{"sobol", one_of<fill_sobol>, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
