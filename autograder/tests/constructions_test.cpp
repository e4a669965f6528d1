// What documents and checks state about constructions: the generating vector of the lattice, the
// pairs of Sobol' dimensions of 6.8, the independence of scrambled digits, the variance by order.

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cmath>
#include <numbers>
#include <numeric>
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

TEST_CASE("lattice_vector is what the search finds, with the first pair fourth") {
  LatticeSearch search;
  auto found = lattice_vector;
  for (std::uint64_t& z : found) z = search.next();
  std::rotate(found.begin(), found.begin() + 2, found.begin() + 8);
  CHECK(found == lattice_vector);
}

/// The length of the shortest k != 0 for which k . z is a multiple of N: the waves that a lattice
/// takes for a constant.
double shortest_dual(std::int64_t z0, std::int64_t z1, std::int64_t n) {
  std::int64_t least = n * n;
  for (std::int64_t a = 0; a * a < least; ++a) {
    for (std::int64_t b = -n; b <= n; ++b) {
      const bool is_dual = (a != 0 || b != 0) && (a * z0 + b * z1) % n == 0;
      if (is_dual) least = std::min(least, a * a + b * b);
    }
  }
  return std::sqrt(static_cast<double>(least));
}

TEST_CASE("the worst pair of the lattice at 1,024 points is the fourth") {
  std::array<double, 4> lengths{};
  for (std::size_t k = 0; k < 4; ++k) {
    lengths[k] = shortest_dual(static_cast<std::int64_t>(lattice_vector[2 * k]),
                               static_cast<std::int64_t>(lattice_vector[2 * k + 1]), 1024);
  }
  CHECK(std::abs(lengths[0] - 31.8) < 0.05);
  CHECK(std::abs(lengths[3] - 14.8) < 0.05);
  CHECK(std::ranges::min_element(lengths) == lengths.end() - 1);
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

TEST_CASE("6.8 uses four of the eight pairs of Sobol' dimensions without empty cells") {
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
  for (const Pair& pair : {Pair{0, 1}, {4, 6}, {16, 20}, {15, 21}}) {
    CHECK(std::find(good.begin(), good.end(), pair) != good.end());
  }
  CHECK(empty_cells(6, 7, 2) == 12);
  CHECK(empty_cells(2, 3, 5) == 512);
}

// How independent the decisions of the solution's nested scrambling are (5.8): its comment and
// docs/going-faster.md say so.

using Scramble = void(std::span<double>, std::uint64_t);

/// Of 15 decisions, how often each of the 2^15 combinations of flips occurred.
constexpr unsigned bits_shown = 4;
using Histogram = std::vector<double>;

/// The flips that turn each value of four bits into `scrambled(value)`, the first bit the lowest:
/// one for each string of bits before a bit.
template <class Scrambled>
void count(Histogram& histogram, Scrambled scrambled) {
  unsigned flips = 0, decision = 0;
  for (unsigned level = 0; level < bits_shown; ++level) {
    for (unsigned string = 0; string < 1u << level; ++string, ++decision) {
      flips |= ((scrambled(string) ^ string) >> level & 1) << decision;
    }
  }
  ++histogram[flips];
}

/// The largest correlations |E{product of signs}| of one, two, three and four flips.
std::array<double, 5> correlations(Histogram sums) {
  const double rounds = std::accumulate(sums.begin(), sums.end(), 0.0);
  for (unsigned bit = 1; bit < sums.size(); bit *= 2) {  // Walsh-Hadamard transform
    for (unsigned i = 0; i < sums.size(); ++i) {
      if ((i & bit) != 0) continue;
      const double a = sums[i], b = sums[i | bit];
      sums[i] = a + b;
      sums[i | bit] = a - b;
    }
  }
  std::array<double, 5> largest{};
  for (unsigned set = 1; set < sums.size(); ++set) {
    const auto size = static_cast<unsigned>(std::popcount(set));
    if (size <= 4) largest[size] = std::max(largest[size], std::abs(sums[set]) / rounds);
  }
  return largest;
}

TEST_CASE("5.8 the flips of four bits are independent in pairs, in threes and in fours") {
  constexpr std::size_t rounds = 20'000;
  const double chance = 6 / std::sqrt(static_cast<double>(rounds));  // 1,365 fours
  for (const auto& [before, depth] :
       {std::pair{0.0, 0}, {0.34375, 5}, {0.34375, 30}, {0.625, 40}}) {
    for (const auto scramble : {mc::owen_scramble, definition::owen_scramble}) {
      Histogram histogram(1u << 15);
      for (std::size_t round = 0; round < rounds; ++round) {
        std::array<double, 16> column{};
        const auto mirrored = [](unsigned k) {
          return (k & 1) * 8 + (k & 2) * 2 + k / 4 % 2 * 2 + k / 8;
        };
        for (unsigned k = 0; k < 16; ++k) column[k] = before + std::ldexp(mirrored(k), -depth - 4);
        scramble(column, round);
        count(histogram, [&, depth = depth](unsigned k) {
          return mirrored(static_cast<unsigned>(std::fmod(std::ldexp(column[k], depth), 1) * 16));
        });
      }
      for (const double correlation : correlations(histogram)) CHECK(correlation < chance);
    }
  }
}

/// The correlations over all random numbers modulo 16 of the two random steps.
template <class Steps>
std::array<double, 5> exact_correlations(Steps steps) {
  Histogram histogram(1u << 15);
  for (std::uint32_t numbers = 0; numbers < 1u << 14; ++numbers) {
    const std::uint32_t m = numbers << 1 | 1, s = numbers >> 3, n = numbers >> 6 | 1,
                        t = numbers >> 10;
    count(histogram, [&](std::uint32_t z) { return steps(z ^ z * 0x3d20adeau, m, s, n, t); });
  }
  return correlations(histogram);
}

TEST_CASE("5.8 what the steps of a hash do to three and to four decisions") {
  const auto two_steps = [](std::uint32_t c) {
    return exact_correlations([=](auto z, auto m, auto s, auto n, auto t) {
      z = z * m + s;
      return (z ^ z * c) * n + t;
    });
  };
  for (const std::uint32_t c : {0x05526c56u, 2u}) {
    CHECK(two_steps(c) == std::array{0., 0., 0., 0., 0.});
  }
  for (const std::uint32_t c : {4u, 0u}) CHECK(two_steps(c) == std::array{0., 0., 0., 0., 1.});
  const auto mixed_after = exact_correlations([](auto z, auto m, auto s, auto, auto) {
    z = z * m + s;
    return z ^ z * 0x05526c56u;
  });
  CHECK(mixed_after == std::array{0., 0., 0., 1., 1.});
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
