// mistake: the lanes live on from call to call, seeded by the first
// caught by: 2.8 a call depends
// hint: nothing static
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  static Rng own(rng());
  right_uniforms(own, out);
}

}  // namespace mc
