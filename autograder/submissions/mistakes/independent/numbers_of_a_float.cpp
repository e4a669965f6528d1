// mistake: fast numbers are made as floats: 24 bits
// caught by: 2.8 a span of any size
// caught by: 2.8 the numbers are uniform
// caught by: 2.8 the last bits
// hint: these are numbers of 24 bits
// hint: which are always 0, or 1?
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  for (double& u : out) u = static_cast<float>(rng() >> 40) * 0x1p-24f;
}

}  // namespace mc
