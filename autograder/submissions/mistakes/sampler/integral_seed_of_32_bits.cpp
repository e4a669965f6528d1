// mistake: hands on the lower half of the seed
// caught by: 6.5 integrate walks through the samples once
// hint: was the seed cut to 32 bits?
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  return right_integrate(scene, sampler, samples, static_cast<unsigned>(seed));
}

}  // namespace mc
