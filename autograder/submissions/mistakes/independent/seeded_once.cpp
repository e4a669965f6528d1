// mistake: the generator of its own lives on: it is seeded by the first call alone
// caught by: 2.2 an estimate depends
// hint: no generator of your own, no clock, nothing static
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  static Rng own(rng());
  return right_estimate(g, n, own);
}

}  // namespace mc
