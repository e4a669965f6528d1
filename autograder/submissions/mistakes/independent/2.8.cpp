// Mistakes in task 2.8.
#include <random>

#include "independent.hpp"

#define uniforms right_uniforms
#include "solutions/independent.cpp"
#undef uniforms

// mistake: adds each number to the previous contents of the span
// hint: write = instead of +=
namespace mc::adds_to_what_is_there {
void uniforms(Rng& rng, std::span<double> out) {
  for (double& u : out) u += to_unit(rng());
}
}  // namespace mc::adds_to_what_is_there

// mistake: runs sixteen lanes of a linear generator in neighboring states, which stay in step
// hint: whose states must be unrelated
namespace mc::lanes_in_step {
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
}  // namespace mc::lanes_in_step

// mistake: seeds four lanes with similar states: each call starts with similar numbers
// hint: whose states must be unrelated
namespace mc::lanes_nearly_alike {
void uniforms(Rng& rng, std::span<double> out) {
  std::array<std::array<std::uint64_t, 4>, 4> state;
  std::array<std::uint64_t, 4> seed;
  for (std::uint64_t& word : seed) word = rng();
  for (std::size_t lane = 0; lane < 4; ++lane) {
    state[lane] = seed;
    state[lane][3] ^= lane << 20;
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
}  // namespace mc::lanes_nearly_alike

// mistake: fills only whole blocks of sixteen
// hint: those of a shorter last block
namespace mc::last_block_unfilled {
void uniforms(Rng& rng, std::span<double> out) {
  right_uniforms(rng, out.first(out.size() / 16 * 16));
}
}  // namespace mc::last_block_unfilled

// mistake: uses one multiplication and one addition per number, whose low bits repeat soon
// hint: the low bits of a linear congruential generator have short periods
namespace mc::linear_congruential {
void uniforms(Rng& rng, std::span<double> out) {
  std::uint64_t x = rng();
  for (double& u : out) {
    x = x * 6364136223846793005u + 1442695040888963407u;  // Knuth's multiplier
    u = to_unit(x);
  }
}
}  // namespace mc::linear_congruential

// mistake: seeds its lanes from a copy of the generator, which it advances by one word only
// hint: numbers occur again: two calls or two lanes begin with the same state
namespace mc::moves_on_by_one {
void uniforms(Rng& rng, std::span<double> out) {
  Rng copy = rng;
  rng();
  std::vector<Rng> lane;
  for (std::size_t i = 0; i < 4; ++i) lane.emplace_back(copy());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = to_unit(lane[i % 4]());
}
}  // namespace mc::moves_on_by_one

// mistake: makes its fast numbers as floats, of 24 bits
// hint: only 24 of 53
namespace mc::numbers_of_a_float {
void uniforms(Rng& rng, std::span<double> out) {
  for (double& u : out) u = static_cast<float>(rng() >> 40) * 0x1p-24f;
}
}  // namespace mc::numbers_of_a_float

// mistake: draws numbers from its own generator, with a fixed seed
// hint: take all random numbers from rng
namespace mc::own_seed_for_the_block {
void uniforms(Rng&, std::span<double> out) {
  Rng own(42);
  right_uniforms(own, out);
}
}  // namespace mc::own_seed_for_the_block

// mistake: keeps its lanes from call to call, seeded by the first
// hint: a static or global variable keeps its value between calls
namespace mc::seeded_by_the_first_call {
void uniforms(Rng& rng, std::span<double> out) {
  static Rng own(rng());
  right_uniforms(own, out);
}
}  // namespace mc::seeded_by_the_first_call

// mistake: seeds its own generator with 32 of the 64 bits of a word
// hint: has only 2^32 initial states
namespace mc::seeds_of_32_bits {
void uniforms(Rng& rng, std::span<double> out) {
  std::mt19937 own(static_cast<std::uint32_t>(rng()));
  for (double& u : out) u = to_unit(std::uint64_t{own()} << 32 | own());
}
}  // namespace mc::seeds_of_32_bits

// mistake: makes two numbers, 16 places apart, from the halves of one word in both orders
// hint: two numbers share bits of one word
namespace mc::halves_exchanged {
void uniforms(Rng& rng, std::span<double> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i % 32 >= 16) continue;
    const std::uint64_t word = rng();
    out[i] = to_unit(word);
    if (i + 16 < out.size()) out[i + 16] = to_unit(word << 32 | word >> 32);
  }
}
}  // namespace mc::halves_exchanged

// mistake: each number is the sum of two before it (Knuth, volume 2, 3.2.2)
// hint: a lagged Fibonacci generator
namespace mc::lagged_fibonacci {
void uniforms(Rng& rng, std::span<double> out) {
  std::array<std::uint64_t, 55> words;
  for (std::uint64_t& word : words) word = rng();
  for (std::size_t k = 0; k < out.size(); ++k) {
    words[k % 55] += words[(k + 31) % 55];
    out[k] = to_unit(words[k % 55]);
  }
}
}  // namespace mc::lagged_fibonacci
