// mistake: seeds each lane by the next word of a copy, and moves the generator on by one
// caught by: 2.8 a span of any size
// hint: do two calls, or two lanes, begin in the same place?
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  Rng copy = rng;
  rng();
  std::vector<Rng> lane;
  for (std::size_t i = 0; i < 4; ++i) lane.emplace_back(copy());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = to_unit(lane[i % 4]());
}

}  // namespace mc
