// mistake: a point set of one sample, N times
// caught by: 6.5 integrate is the mean over the samples
// caught by: 6.5 integrate walks through the samples once
// hint: generate() once before the loop
#include "sampler.hpp"
#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  if (samples == 0) throw std::invalid_argument("samples: there are none");
  Rng seeds(seed);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) {
    sampler.generate(1, seeds());
    sum += scene.sample(sampler);
  }
  return sum / static_cast<double>(samples);
}

}  // namespace mc
