// mistake: the generator does not move on: the next call begins with the same numbers
// caught by: 2.8 a span of any size
// caught by: 2.8 the numbers are independent
// caught by: 2.8 the first numbers of a call are independent
// hint: do two calls, or two lanes, begin in the same place?
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  Rng copy = rng;
  right_uniforms(copy, out);
}

}  // namespace mc
