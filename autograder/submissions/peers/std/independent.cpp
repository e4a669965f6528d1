// peer: the C++ standard library: std::mt19937_64, std::uniform_real_distribution
// fails: 2.1 the upper 53 bits
// because: generate_canonical rounds 64 bits to 53, and keeps more than a shift near 0
#include <random>

namespace mc {
using Engine = std::mt19937_64;
using Uniform = std::uniform_real_distribution<double>;
}  // namespace mc

#include "autograder/submissions/peers/with_engine.hpp"

namespace mc {

double to_unit(std::uint64_t bits) {
  Word word{bits};
  return std::generate_canonical<double, 53>(word);
}

}  // namespace mc
