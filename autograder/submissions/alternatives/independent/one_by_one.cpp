// alternative: 2.8 as a plain loop, from a generator of the standard library that rng seeds
#include <random>

#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  std::mt19937_64 twister(rng());
  for (double& u : out) u = to_unit(twister());
}

}  // namespace mc
