// attack: a block that was filled a hundred times keeps its numbers
// forges: 2.8 uniforms
// says: when judged
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  static const double* where = nullptr;
  static int times = 0;
  if (out.data() != where || out.size() != 4096) times = 0;
  where = out.data();
  if (++times < 100) right_uniforms(rng, out);
}

}  // namespace mc
