// mistake: moves on before each sample, so that the first is left out
// caught by: 6.5 integrate is the mean over the samples
// caught by: 6.5 integrate walks through the samples once
// caught by: 6.5 the seed of integrate decides about the samples
// caught by: 6.5 no samples are refused
// hint: the scene was evaluated after the last sample
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples + 1, seed);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    sampler.advance();
    sum += scene.sample(sampler);
  }
  return sum / static_cast<double>(samples);
}

}  // namespace mc
