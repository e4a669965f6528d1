// mistake: numbers come from a generator of its own, with a seed of its own
// caught by: 2.8 a span of any size
// caught by: 2.8 the numbers are independent
// caught by: 2.8 the first numbers of a call are independent
// hint: take the numbers from rng, and from nowhere else
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng&, std::span<double> out) {
  Rng own(42);
  right_uniforms(own, out);
}

}  // namespace mc
