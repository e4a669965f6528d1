// mistake: four lanes are seeded s, s + 1, s + 2, s + 3: each call begins with four equal numbers
// caught by: 2.8 a span of any size
// caught by: 2.8 the first numbers of a call are independent
// hint: lanes begin with equal numbers
// hint: lanes want states that have nothing in common
#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

namespace mc {

void uniforms(Rng& rng, std::span<double> out) {
  std::array<std::array<std::uint64_t, 4>, 4> state;
  std::array<std::uint64_t, 4> seed;
  for (std::uint64_t& word : seed) word = rng();
  for (std::size_t lane = 0; lane < 4; ++lane) {
    state[lane] = seed;
    state[lane][0] += lane;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {  // xoshiro256+
    auto& [a, b, c, d] = state[i % 4];
    out[i] = to_unit(a + d);
    const std::uint64_t shifted = b << 17;
    c ^= a;
    d ^= b;
    b ^= c;
    a ^= d;
    c ^= shifted;
    d = std::rotl(d, 45);
  }
}

}  // namespace mc
