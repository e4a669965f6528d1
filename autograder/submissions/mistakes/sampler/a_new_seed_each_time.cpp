// mistake: counts its calls, so that no two have the same seed
// caught by: 6.5 the seed of integrate decides about the samples
// hint: is there anything static
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  static std::uint64_t calls = 0;
  return right_integrate(scene, sampler, samples, seed + mix_bits(calls++));
}

}  // namespace mc
