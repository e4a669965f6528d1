// mistake: only whole blocks of sixteen are filled
// caught by: 2.8 a span of any size
// hint: it was not filled. The last, shorter block?
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  right_uniforms(rng, out.first(out.size() / 16 * 16));
}

}  // namespace mc
