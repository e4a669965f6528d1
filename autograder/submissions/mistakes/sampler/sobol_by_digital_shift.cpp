// mistake: flips the same bits of all points of a dimension
// caught by: 6.3 the first dimensions of sobol are
// caught by: 6.3 each of the first twenty
// hint: owen_scramble of lab 5
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void shifted(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables&) {
  sobol(static_cast<unsigned>(dimension), 0, x);
  const std::uint64_t shift = seed >> 11;
  for (double& value : x) {
    value = static_cast<double>(static_cast<std::uint64_t>(value * 0x1p53) ^ shift) * 0x1p-53;
  }
}

constexpr Kind wrong{"sobol", one_of<shifted>, two_of<shifted>};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
