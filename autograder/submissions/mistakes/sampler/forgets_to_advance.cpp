// mistake: never moves on to the next sample
// caught by: 6.5 integrate is the mean over the samples
// caught by: 6.5 integrate walks through the samples once
// hint: advance() once after each sample
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i) sum += scene.sample(sampler);
  return sum / static_cast<double>(samples);
}

}  // namespace mc
