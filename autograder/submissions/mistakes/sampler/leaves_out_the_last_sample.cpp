// mistake: one sample too few, over N
// caught by: 6.5 integrate is the mean over the samples
// caught by: 6.5 integrate walks through the samples once
// caught by: 6.5 every kind is unbiased
// hint: the last sample is left out
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < samples; ++i, sampler.advance()) sum += scene.sample(sampler);
  return sum / static_cast<double>(samples);
}

}  // namespace mc
