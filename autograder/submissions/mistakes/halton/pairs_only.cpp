// mistake: a hash that scrambles pairs independently (Owen's variance), but not triples
// fails: 5.8
// hint: pairs of decisions are independent, but not triples
#include "halton.hpp"

#define owen_scramble right_owen_scramble
#include "solutions/halton.cpp"
#undef owen_scramble

namespace mc {
namespace {

std::uint64_t mirrored_64(std::uint64_t word) {
  return std::uint64_t{mirrored(static_cast<std::uint32_t>(word))} << 32 |
         mirrored(static_cast<std::uint32_t>(word >> 32));
}

}  // namespace

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  Rng rng(seed);
  const std::uint64_t s = rng();
  const std::uint64_t m = rng() | 1;
  for (double& value : column) {
    std::uint64_t z = mirrored_64(static_cast<std::uint64_t>(value * 0x1p53) << 11);
    z ^= z << 5;
    z = z * m + s;
    z ^= z * 0xb82f1e52d1342544u;
    value = static_cast<double>(mirrored_64(z) >> 11) * 0x1p-53;
  }
}

}  // namespace mc
