// mistake: shuffles every use into the same order
// caught by: 6.2 every use has a random order of its own
// caught by: 6.3 sobol begins anew after eight dimensions
// caught by: 6.3 halton begins anew after eight dimensions
// hint: each wants a shuffle of its own
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
