// mistake: next() and next2() both begin with the first dimension
// caught by: 6.3 the first dimensions of sobol are
// caught by: 6.3 sobol begins anew after eight dimensions
// hint: takes the next one of the sequence
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void one(const Use& use, std::span<double> x, Rng& rng) {
  one_of<fill_sobol>({use.number, use.number, use.order, use.tables}, x, rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  two_of<fill_sobol>({use.number, 2 * use.number, use.order, use.tables}, x, y, rng);
}

constexpr Kind wrong{"sobol", one, two};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
