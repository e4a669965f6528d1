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

}  // namespace
}  // namespace mc

// mistake: flips each bit position alike, not by the string of bits before it
// hint: that is a digital shift
namespace mc::digital_shift {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t flips = Rng(seed)() >> 11;
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53);
    value = static_cast<double>(word ^ flips) * 0x1p-53;
  }
}
}  // namespace mc::digital_shift

// mistake: uses the hash of Laine and Karras 2011, which only adds the seed: not Owen's variance
// hint: a separate flip for each string of bits
namespace mc::laine_karras_2011 {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  Rng rng(seed);
  const std::uint64_t word = rng();
  for (double& value : column) {
    std::uint64_t z = mirrored_64(static_cast<std::uint64_t>(value * 0x1p53) << 11);
    z += word;
    z ^= z * 0x6c50b47cu;
    z ^= z * 0xb82f1e52u;
    z ^= z * 0xc7afe638u;
    z ^= z * 0x8d22f6e6u;
    value = static_cast<double>(mirrored_64(z) >> 11) * 0x1p-53;
  }
}
}  // namespace mc::laine_karras_2011

// mistake: hashes seed + level: the next seed repeats the flips of the next level
// hint: seed + level is the same
namespace mc::level_added_to_seed {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= mix_bits(mix_bits(mix_bits(seed + k)) ^ before) >> 63 << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}
}  // namespace mc::level_added_to_seed

// mistake: uses Matousek's random linear scrambling: correct for two and three decisions, not for four
// hint: pairs and triples of decisions are independent, but larger groups are not
namespace mc::linear_scrambling {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  Rng rng(seed);
  const std::uint64_t shift = rng() >> 11;
  std::array<std::uint64_t, 53>
      columns;  // what bit k of a value, the first being 0, does to the word
  for (unsigned k = 0; k < 53; ++k) {
    const std::uint64_t bit = std::uint64_t{1} << (52 - k);
    columns[k] = bit | (rng() & (bit - 1));
  }
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53);
    std::uint64_t scrambled = shift;
    for (unsigned k = 0; k < 53; ++k) {
      if (word >> (52 - k) & 1) scrambled ^= columns[k];
    }
    value = static_cast<double>(scrambled) * 0x1p-53;
  }
}
}  // namespace mc::linear_scrambling

// mistake: scrambles only the first 32 bits of a value and loses the others
// hint: only 32 bits were scrambled; scramble all 53
namespace mc::scrambles_32_bits {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  right_owen_scramble(column, seed);
  for (double& value : column) value = std::floor(value * 0x1p32) * 0x1p-32;
}
}  // namespace mc::scrambles_32_bits

// mistake: scrambles 20 bits by the bits before them, and the others by a digital shift
// hint: a separate flip for each string of bits
namespace mc::scrambles_20_bits {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
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
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  right_owen_scramble(column, static_cast<std::uint32_t>(seed));
}
}  // namespace mc::seed_of_32_bits

// mistake: hashes the bits before as a number: 0, 00 and 000 are the same
// hint: 0 and 00 are different strings before a bit
namespace mc::string_without_its_length {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= mix_bits(mix_bits(hashed ^ before)) >> 63 << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}
}  // namespace mc::string_without_its_length

// mistake: from the 16th bit on, a flip is the parity of some of the bits before
// hint: pairs and triples of decisions are independent, but larger groups are not
namespace mc::linear_from_bit_16 {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t hashed = mix_bits(mix_bits(seed) + 1);
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k), level = mix_bits(hashed + k);
      const bool parity = (std::popcount(before & level) + (level >> 63)) % 2 != 0;
      const bool flip = k < 16 ? mix_bits(level ^ before) >> 63 != 0 : parity;
      flips |= std::uint64_t{flip} << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}
}  // namespace mc::linear_from_bit_16

// mistake: hashes the exclusive or of seed and string
// hint: not their exclusive or or sum
namespace mc::seed_xor_string {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k) << (64 - k);
      flips |= mix_bits(mix_bits(seed ^ before) + k) >> 63 << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}
}  // namespace mc::seed_xor_string

// mistake: the hash of Vegdahl with one random multiplication and addition: correct in pairs
// hint: pairs of decisions are independent, but not triples
namespace mc::one_multiplication {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  const std::uint64_t add = mix_bits(mix_bits(seed) ^ 0x5bf03635u);
  const std::uint64_t multiply = mix_bits(add + 1) | 1;
  for (double& value : column) {
    std::uint64_t z = mirrored_64(static_cast<std::uint64_t>(value * 0x1p53) << 11);
    z ^= z * 0x3d20adea3d20adeau;
    z = z * multiply + add;
    z ^= z * 0x05526c5605526c56u;
    z ^= z * 0x53a2286453a22864u;
    value = static_cast<double>(mirrored_64(z) >> 11) * 0x1p-53;
  }
}
}  // namespace mc::one_multiplication

// mistake: does not mix: a flip is the lowest bit of a sum
// hint: mix seed, position and bits by a hash
namespace mc::unmixed {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  for (double& value : column) {
    const auto word = static_cast<std::uint64_t>(value * 0x1p53) << 11;
    std::uint64_t flips = 0;
    for (unsigned k = 0; k < 53; ++k) {
      const std::uint64_t before = k == 0 ? 0 : word >> (64 - k);
      flips |= (seed + k + 3 * before) % 2 << (63 - k);
    }
    value = static_cast<double>((word ^ flips) >> 11) * 0x1p-53;
  }
}
}  // namespace mc::unmixed

// mistake: takes the seed for a signed number and drops its sign
// hint: a seed s and ~s or -s give the same numbers
namespace mc::seed_without_sign {
void owen_scramble(std::span<double> column, std::uint64_t seed) {
  right_owen_scramble(column, std::min(seed, ~seed + 1));
}
}  // namespace mc::seed_without_sign
