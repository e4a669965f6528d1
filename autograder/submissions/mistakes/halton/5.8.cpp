// Mistakes in task 5.8.
#include "halton.hpp"

#include <cmath>

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {
namespace {

std::uint64_t mirrored_64(std::uint64_t word) {
  return std::uint64_t{mirrored(lower_half(word))} << 32 | mirrored(upper_half(word));
}

/// Flips bit k of each value if flip(the bits before it, k).
template <class Flip>
void flip_bits(std::span<double> column, Flip flip) {
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= std::uint64_t{flip(before, k)} << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}

bool top_bit(std::uint64_t hash) {
  return hash >> 63 != 0;
}

/// Replaces each value by hash(its bits, the last one first).
template <class Hash>
void hash_mirrored(std::span<double> column, Hash hash) {
  for (double& value : column) {
    const std::uint64_t z = hash(mirrored_64(static_cast<std::uint64_t>(value * 0x1p53) << 11));
    value = static_cast<double>(mirrored_64(z) >> 11) * 0x1p-53;
  }
}

}  // namespace
}  // namespace mc

#define OWEN_SCRAMBLE void owen_scramble(std::span<double> column, std::uint64_t seed)

// mistake: flips each bit position alike, not by the string of bits before it
// hint: that is a digital shift
namespace mc::digital_shift {
OWEN_SCRAMBLE {
  flip_bits(column, [flips = Rng(seed)()](auto, unsigned k) { return top_bit(flips << k); });
}
}  // namespace mc::digital_shift

// mistake: uses the hash of Laine and Karras 2011, which only adds the seed: not Owen's variance
// hint: a separate flip for each string of bits
namespace mc::laine_karras_2011 {
OWEN_SCRAMBLE {
  hash_mirrored(column, [word = Rng(seed)()](std::uint64_t z) {
    z += word;
    z ^= z * 0x6c50b47cu;
    z ^= z * 0xb82f1e52u;
    z ^= z * 0xc7afe638u;
    return z ^ z * 0x8d22f6e6u;
  });
}
}  // namespace mc::laine_karras_2011

// mistake: hashes seed + level: the next seed repeats the flips of the next level
// hint: scrambled 0 has the same digits, shifted by one place
// hint: seed + level is the same
namespace mc::level_added_to_seed {
OWEN_SCRAMBLE {
  flip_bits(column, [=](std::uint64_t before, unsigned k) {
    return top_bit(mix_bits(mix_bits(mix_bits(seed + k)) ^ before));
  });
}
}  // namespace mc::level_added_to_seed

// mistake: Matousek's random linear scrambling: correct for two and three decisions, not for four
// hint: pairs and triples of decisions are independent, but larger groups are not
namespace mc::linear_scrambling {
OWEN_SCRAMBLE {
  Rng rng(seed);
  const std::uint64_t shift = rng() >> 11;
  std::array<std::uint64_t, 53> rows;  // the bits that change the flip of bit k
  for (std::uint64_t& row : rows) row = rng();
  flip_bits(column, [&](std::uint64_t before, unsigned k) {
    return (std::popcount(before & rows[k]) + (shift >> k)) % 2 != 0;
  });
}
}  // namespace mc::linear_scrambling

// mistake: scrambles only the first 32 bits of a value and loses the others
// hint: only 32 bits were scrambled; scramble all 53
namespace mc::scrambles_32_bits {
OWEN_SCRAMBLE {
  right_owen_scramble(column, seed);
  for (double& value : column) value = std::floor(value * 0x1p32) * 0x1p-32;
}
}  // namespace mc::scrambles_32_bits

// mistake: scrambles 20 bits by the bits before them, and the others by a digital shift
// hint: a separate flip for each string of bits
namespace mc::scrambles_20_bits {
OWEN_SCRAMBLE {
  const std::uint64_t last = (std::uint64_t{1} << 33) - 1, shift = Rng(~seed)() & last;
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53);
    right_owen_scramble(std::span(&value, 1), seed);
    const auto first = static_cast<std::uint64_t>(value * 0x1p53) & ~last;
    value = static_cast<double>(first | ((word ^ shift) & last)) * 0x1p-53;
  }
}
}  // namespace mc::scrambles_20_bits

// mistake: loses the upper half of the seed
// hint: do not truncate the seed to 32 bits
namespace mc::seed_of_32_bits {
OWEN_SCRAMBLE {
  right_owen_scramble(column, static_cast<std::uint32_t>(seed));
}
}  // namespace mc::seed_of_32_bits

// mistake: hashes the bits before as a number: 0, 00 and 000 are the same
// hint: 0 and 00 are different strings before a bit
namespace mc::string_without_its_length {
OWEN_SCRAMBLE {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);
  flip_bits(column, [=](std::uint64_t before, unsigned) {
    return top_bit(mix_bits(mix_bits(hashed ^ before)));
  });
}
}  // namespace mc::string_without_its_length

// mistake: from the 16th bit on, a flip is the parity of some of the bits before
// hint: pairs and triples of decisions are independent, but larger groups are not
namespace mc::linear_from_bit_16 {
OWEN_SCRAMBLE {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);
  flip_bits(column, [=](std::uint64_t before, unsigned k) {
    const std::uint64_t level = mix_bits(hashed + k);
    if (k < 16) return top_bit(mix_bits(level ^ before));
    return (std::popcount(before & level) + (level >> 63)) % 2 != 0;
  });
}
}  // namespace mc::linear_from_bit_16

// mistake: hashes the exclusive or of seed and string
// hint: not their exclusive or or sum
namespace mc::seed_xor_string {
OWEN_SCRAMBLE {
  flip_bits(column, [=](std::uint64_t before, unsigned k) {
    return top_bit(mix_bits(mix_bits(seed ^ (k == 0 ? 0 : before << (64 - k))) + k));
  });
}
}  // namespace mc::seed_xor_string

// mistake: does not mix: a flip is the lowest bit of a sum
// hint: mix seed, position and bits by a hash
namespace mc::unmixed {
OWEN_SCRAMBLE {
  flip_bits(column,
            [=](std::uint64_t before, unsigned k) { return (seed + k + 3 * before) % 2 != 0; });
}
}  // namespace mc::unmixed

// mistake: takes the seed for a signed number and drops its sign
// hint: a seed s and ~s or -s give the same numbers
namespace mc::seed_without_sign {
OWEN_SCRAMBLE {
  right_owen_scramble(column, std::min(seed, ~seed + 1));
}
}  // namespace mc::seed_without_sign

// mistake: scrambles long columns in blocks of 1,024 values, and loses the rest
// hint: a function of value and seed only
namespace mc::rest_of_a_block {
OWEN_SCRAMBLE {
  const std::size_t size = column.size();
  right_owen_scramble(column.first(size > 1024 ? size / 1024 * 1024 : size), seed);
}
}  // namespace mc::rest_of_a_block
