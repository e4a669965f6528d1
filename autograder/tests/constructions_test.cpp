// What documents and checks state about constructions: the generating vector of the lattice, the
// pairs of Sobol' dimensions of 6.3, the independence of scrambled digits, the variance by order.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "checks/sampler/sequences.hpp"
#include "checks/support/catch.hpp"
#include "common/lattice_vector.hpp"
#include "halton.hpp"
#include "measurements/sampler/anova.hpp"
#include "tests/lattice_search.hpp"

namespace mc::definition {
void owen_scramble(std::span<double> column, std::uint64_t seed);
}

namespace mc::checks {
namespace {

using measurements::LatticeSearch;

TEST_CASE("lattice_vector is what the search finds") {
  LatticeSearch search;
  for (const std::uint64_t z : lattice_vector) CHECK(search.next() == z);
}

/// On the line e^2 is known: the sum of w over the multiples of 1/N is 2 pi^2 / (6 N).
TEST_CASE("the worst-case error of N points of the line") {
  LatticeSearch search;
  search.next();
  double n = 4;
  for (const double square : search.worst_case()) {
    const double exact = 0.1 * std::numbers::pi * std::numbers::pi / (6 * n * n);
    CHECK(std::abs(square - exact) < 1e-12);
    n *= 2;
  }
  CHECK(n == 131'072);
}

/// The number of empty cells in the square grid of 4^m cells for the first 4^m points of two
/// dimensions.
std::size_t empty_cells(unsigned a, unsigned b, unsigned m) {
  const auto x = sobol_directions(a), y = sobol_directions(b);
  std::vector<bool> taken(std::size_t{1} << 2 * m);
  for (std::size_t i = 0; i < taken.size(); ++i) {
    const std::uint32_t column = sobol_word(x, i) >> (32 - m), row = sobol_word(y, i) >> (32 - m);
    taken[column << m | row] = true;
  }
  return static_cast<std::size_t>(std::count(taken.begin(), taken.end(), false));
}

using Pair = std::pair<unsigned, unsigned>;

TEST_CASE("6.3 uses four of the eight pairs of Sobol' dimensions without empty cells") {
  std::vector<Pair> good;
  for (unsigned a = 0; a < joe_kuo.size(); ++a) {
    for (unsigned b = a + 1; b < joe_kuo.size(); ++b) {
      bool fills_all = true;
      for (unsigned m = 1; m <= 5; ++m) fills_all = fills_all && empty_cells(a, b, m) == 0;
      if (fills_all) good.emplace_back(a, b);
    }
  }
  const std::vector<Pair> all{{0, 1},  {0, 12},  {0, 13},  {4, 6},
                              {7, 13}, {10, 20}, {15, 21}, {16, 20}};
  CHECK(good == all);
  for (std::size_t k = 0; k < block_dims; k += 2) {
    const Pair pair{sobol_block[k], sobol_block[k + 1]};
    CHECK(std::find(good.begin(), good.end(), pair) != good.end());
  }
  CHECK(empty_cells(6, 7, 2) == 12);
  CHECK(empty_cells(2, 3, 5) == 512);
}

// How independent the decisions of the solution's nested scrambling are (5.8): exactly in pairs and
// triples, not in fours, which its comment and docs/answers say.

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
  const auto fast = correlations(mc::owen_scramble, rounds),
             exact = correlations(definition::owen_scramble, rounds);
  for (const unsigned size : {1u, 2u, 3u}) CHECK(fast[size] < chance);
  for (const unsigned size : {1u, 2u, 3u, 4u}) CHECK(exact[size] < chance);
  CHECK(std::abs(fast[4] - 0.25) < chance);
}

/// Mean 0, variance 1.
double centered(double x) {
  return std::sqrt(12.0) * (x - 0.5);
}

/// (1 + a h(x0)) (1 + b h(x1)) (1 + c h(x2)): a set of factors makes the product of their squares.
struct Product {
  static constexpr std::string_view uses = "next2 next";
  double a = 0.6, b = 0.3, c = 0.8;
  double operator()(Sampler& sampler) const {
    const Point2 p = sampler.next2();
    return (1 + a * centered(p.x)) * (1 + b * centered(p.y)) * (1 + c * centered(sampler.next()));
  }
};

TEST_CASE("the variance by order of a product") {
  const Product f;
  const double a = f.a * f.a, b = f.b * f.b, c = f.c * f.c;
  const double whole = (1 + a) * (1 + b) * (1 + c) - 1;
  Rng rng(5);
  const Anova anova = anova_of(f, 1 << 17, rng);
  REQUIRE(anova.by_order.size() == 3);
  // Fractions of a variance, from 131,072 points: a standard error of some 0.003.
  CHECK(anova.by_order[0] == Approx((a + b + c) / whole).margin(0.015));
  CHECK(anova.by_order[1] == Approx((a * b + a * c + b * c) / whole).margin(0.015));
  CHECK(anova.by_order[2] == Approx(a * b * c / whole).margin(0.015));
  CHECK(anova.by_order[0] + anova.by_order[1] + anova.by_order[2] == Approx(1).epsilon(1e-9));
  // The second use alone, and the first use with both of its dimensions.
  CHECK(anova.within_uses == Approx((a + b + a * b + c) / whole).margin(0.015));
}

}  // namespace
}  // namespace mc::checks
