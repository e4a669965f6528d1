// mistake: adds up in an int, which cuts off what every sample has behind the point
// caught by: 6.5 integrate is the mean over the samples
// caught by: 6.5 every kind is unbiased
// hint: added up in an int
#include "sampler.hpp"

#define integrate right_integrate
#include "solutions/sampler.cpp"
#undef integrate

namespace mc {

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  int sum = 0;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) {
    sum = static_cast<int>(sum + scene.sample(sampler));
  }
  return static_cast<double>(sum) / static_cast<double>(samples);
}

}  // namespace mc
