// mistake: 0 for no samples
// caught by: 6.5 no samples are refused
// hint: a mean of no samples is nothing
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  return samples == 0 ? 0 : right_integrate(scene, sampler, samples, seed);
}

}  // namespace mc
