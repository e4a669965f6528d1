// How independent the decisions of the solution's nested scrambling are (5.8): exactly in pairs and
// triples, not in fours, which its comment and docs/answers say.

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "checks/support/catch.hpp"
#include "halton.hpp"

namespace mc::definition {
void owen_scramble(std::span<double> column, std::uint64_t seed);
}

namespace mc::tests {
namespace {

using Scramble = void(std::span<double>, std::uint64_t);

/// The largest correlations |E{product of signs}| of the flips of the fourth bit, one for each
/// string of three bits before it, by how many of the eight are multiplied.
std::vector<double> correlations(Scramble* scramble, std::size_t rounds) {
  constexpr unsigned strings = 8;
  std::vector<double> sums(1u << strings), largest(strings + 1);
  for (std::size_t round = 0; round < rounds; ++round) {
    std::vector<double> column(strings);
    for (unsigned k = 0; k < strings; ++k) column[k] = k / 8.0;
    scramble(column, round);
    unsigned flips = 0;
    for (unsigned k = 0; k < strings; ++k) {
      flips |= (static_cast<unsigned>(column[k] * 16) & 1) << k;
    }
    for (unsigned set = 0; set < sums.size(); ++set) {
      sums[set] += std::popcount(flips & set) % 2 == 0 ? 1 : -1;
    }
  }
  for (unsigned set = 0; set < sums.size(); ++set) {
    double& most = largest[static_cast<unsigned>(std::popcount(set))];
    most = std::max(most, std::abs(sums[set]) / static_cast<double>(rounds));
  }
  return largest;
}

TEST_CASE("5.8 the solution's flips are independent in pairs and triples, not in fours") {
  constexpr std::size_t rounds = 100'000;
  // Six standard errors; there are 28 pairs, 56 triples, 70 fours.
  const double chance = 6 / std::sqrt(static_cast<double>(rounds));
  const auto fast = correlations(owen_scramble, rounds),
             exact = correlations(definition::owen_scramble, rounds);
  for (const unsigned size : {1u, 2u, 3u}) CHECK(fast[size] < chance);
  for (const unsigned size : {1u, 2u, 3u, 4u}) CHECK(exact[size] < chance);
  CHECK(std::abs(fast[4] - 0.25) < chance);
}

}  // namespace
}  // namespace mc::tests
