// mistake: hands on the lower half of the seed
// caught by: 6.5 the seed of integrate decides about the samples
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
