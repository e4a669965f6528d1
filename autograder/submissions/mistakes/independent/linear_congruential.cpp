// mistake: one multiplication and one addition a number: its low bits repeat soon
// caught by: 2.8 the last bits
// hint: the low bits of a linear congruential generator repeat soon
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  std::uint64_t x = rng();
  for (double& u : out) {
    x = x * 6364136223846793005u + 1442695040888963407u;  // Knuth's multiplier
    u = to_unit(x);
  }
}

}  // namespace mc
