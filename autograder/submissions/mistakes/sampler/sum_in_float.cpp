// mistake: adds up in a float
// caught by: 6.5 integrate is the mean over the samples
// hint: the mean of what the scene had for each sample
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  float sum = 0;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) {
    sum += static_cast<float>(scene.sample(sampler));
  }
  return sum / static_cast<double>(samples);
}

}  // namespace mc
