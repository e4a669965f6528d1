// mistake: shuffles every sample dimension by the same permutation
// caught by: 6.2 each sample dimension has a permutation of its own
// caught by: 6.3 sobol begins anew after eight dimensions
// caught by: 6.3 halton begins anew after eight dimensions
// hint: each needs a shuffle of its own
#include "sampler.hpp"

namespace mc {
namespace {

void same_order(std::span<double> x, Rng&) {
  Rng always(x.size());
  shuffle(x, always);
}

}  // namespace
}  // namespace mc

#define shuffle same_order
#include "solutions/sampler.cpp"
