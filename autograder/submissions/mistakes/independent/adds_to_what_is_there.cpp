// mistake: adds each number to what stands in the span
// caught by: 2.8 a span of any size
// caught by: 2.8 a call depends
// caught by: 2.8 a generator of one word
// caught by: 2.8 the numbers are uniform
// caught by: 2.8 the numbers are independent
// caught by: 2.8 the last bits
// caught by: 2.8 the first numbers of a call are independent
// hint: = in place of +=
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  for (double& u : out) u += to_unit(rng());
}

}  // namespace mc
