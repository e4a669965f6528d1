// mistake: next() and next2() both begin with the first dimension
// caught by: 6.3 the uses of sobol are Sobol' dimensions
// caught by: 6.3 sobol has any number of uses
// hint: each new use takes the next ones
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void one(Use use, std::span<double> x, Rng& rng) {
  one_of<fill_sobol>({use.number, use.number}, x, rng);
}
void two(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  two_of<fill_sobol>({use.number, 2 * use.number}, x, y, rng);
}

constexpr Kind wrong{"sobol", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
