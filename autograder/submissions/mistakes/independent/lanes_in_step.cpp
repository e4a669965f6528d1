// mistake: sixteen lanes with neighbouring states of a linear generator: they run in step
// caught by: 2.8 the numbers are independent
// caught by: 2.8 the last bits
// caught by: 2.8 the first numbers of a call are independent
// hint: do lanes run in step?
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  std::array<std::uint64_t, lanes> state;
  const std::uint64_t seed = rng();
  for (std::size_t lane = 0; lane < lanes; ++lane) state[lane] = seed + lane;
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::uint64_t& x = state[i % lanes];
    x = x * 6364136223846793005u + 1442695040888963407u;  // Knuth's multiplier
    out[i] = to_unit(x);
  }
}

}  // namespace mc
