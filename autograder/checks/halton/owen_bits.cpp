// 5.8, value by value: which bits are flipped, and what decides about it.

#include <numeric>

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_inverses.hpp"
#include "checks/halton/randomness.hpp"
#include "checks/halton/scrambled_bits.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

std::string shared_hint(double a, double b, std::size_t k) {
  const auto is_whole = [](double x) { return x == std::floor(x); };
  if (!is_whole(a * 0x1p53) || !is_whole(b * 0x1p53)) return "no bit stands behind the 53rd";
  if (k >= 31 && is_whole(a * 0x1p32) && is_whole(b * 0x1p32)) {
    return "53 bits of a value are scrambled, not 32";
  }
  return "the flip of a bit must not depend on the bits behind it";
}

CHECK_CASE("5.8 scrambled values share the bits that the values share", "[5.8][points:2][main]") {
  Rng rng = check_rng();
  // Pairs that share k bits exactly, for every k; and one value three times.
  std::vector<double> x;
  for (int k = 0; k < 53; ++k) {
    const std::uint64_t word = rng() >> 11, bit = std::uint64_t{1} << (52 - k);
    const std::uint64_t other = (word ^ bit) ^ (rng() & (bit - 1));
    x.push_back(static_cast<double>(word) * half_ulp);
    x.push_back(static_cast<double>(other) * half_ulp);
  }
  x.insert(x.end(), {0, x[0], x[0], 1 - half_ulp});
  const auto seeds = fresh_seeds(rng, 3);
  const auto measured = MEASURE(owen_scramble, x, seeds);
  const SetsOfPoints got(measured.exactly(3 * x.size(), unit), x.size(), 1);
  for (std::size_t set = 0; set < 3; ++set) {
    const auto column = got.column(set, 0);
    for (std::size_t k = 0; k < 53; ++k) {
      const double a = column[2 * k], b = column[2 * k + 1];
      const int shared = shared_bits(a, b);
      const bool whole = a * 0x1p53 == std::floor(a * 0x1p53);
      expect_that(
          shared == static_cast<int>(k) && whole,
          fmt::format("{}: {:.17g} and {:.17g} became {:.17g} and {:.17g}, which share {} bits",
                      measured.call, x[2 * k], x[2 * k + 1], a, b, shared),
          fmt::format("{} bits, of 53, as the values themselves", k),
          "the flip of a bit depends on the bits before it: those two share; they differ in the "
          "next, which is flipped in both or in neither. So a net stays a net",
          shared_hint(a, b, k));
    }
    expect_that(column[107] == column[0] && column[108] == column[0],
                fmt::format("{}: {:.17g} became {:.17g}, {:.17g} and {:.17g}", measured.call, x[0],
                            column[0], column[107], column[108]),
                "the same number three times", "a function of value and seed alone",
                "where a value stands in its column must not matter");
  }
  const auto alone = MEASURE(owen_scramble, {x[50]}, {seeds[1]});
  const double here = alone.exactly(1, unit)[0], there = got.column(1, 0)[50];
  expect_that(here == there, fmt::format("{} = {:.17g}", alone.call, here),
              fmt::format("{:.17g}, as in a longer column", there),
              "a function of value and seed alone",
              "neither the column before nor its size must matter");
}

/// Bits first … first + count - 1 of a value's 53, as a number in [0, 1).
double bits_between(std::uint64_t bits, int first, int count) {
  const std::uint64_t all = (std::uint64_t{1} << count) - 1;
  return static_cast<double>(bits >> (53 - first - count) & all) * std::ldexp(1, -count);
}

CHECK_CASE("5.8 each bit is flipped at random for each string before it", "[5.8][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t count = 4000;
  // 0 and 1/2 differ in their first bit; the others share 19 bits and differ in the 20th.
  const double deep = static_cast<double>(rng() >> 44) * 0x1p-20;
  const std::vector<double> x{0, 0.5, deep,
                              wrapped(deep + (bit_of(deep, 19) ? -0x1p-20 : 0x1p-20))};
  const auto measured = MEASURE(owen_scramble, x, fresh_seeds(rng, count));
  const SetsOfPoints got(measured.exactly(4 * count, unit), 4, 1);
  const std::string& call = measured.call;
  std::vector<double> zero, fine, apart, deep_apart;
  std::vector<std::uint64_t> flips(8);
  std::size_t same_second = 0, one_flip = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto column = got.column(i, 0);
    const std::uint64_t a = bits_of(column[0]), b = bits_of(column[1]);
    for (const auto& [j, shared] : {std::pair{std::size_t{0}, 0}, {std::size_t{2}, 19}}) {
      expect_that(shared_bits(column[j], column[j + 1]) == shared,
                  fmt::format("{}: {:.17g} and {:.17g} became {:.17g} and {:.17g}", call, x[j],
                              x[j + 1], column[j], column[j + 1]),
                  fmt::format("two numbers that share {} bits and differ in the next", shared),
                  "the flip of a bit depends on the bits before it", "");
    }
    zero.push_back(column[0]);
    fine.push_back(bits_between(a, 33, 20));
    apart.push_back(bits_between(a ^ b, 1, 52));
    deep_apart.push_back(bits_between(bits_of(column[2]) ^ bits_of(column[3]), 20, 33));
    ++flips[bit_of(column[0], 0) << 2 | bit_of(column[0], 1) << 1 | bit_of(column[1], 1)];
    same_second += bit_of(column[0], 1) == bit_of(column[1], 1) ? 1u : 0u;
    one_flip += a == 0 || a == (std::uint64_t{1} << 53) - 1 ? 1u : 0u;
  }
  const Hints hints{
      {},
      one_flip == count
          ? "all bits of 0 are flipped alike: 0, 00 and 000 before a bit are different strings"
      : same_second == count
          ? "every bit is flipped alike in both halves: that is a digital shift, one flip for a "
            "level; nested scrambling draws one for each string of bits before"
          : "each bit of 53 is flipped with probability 1/2"};
  const bool of_32 = std::all_of(fine.begin(), fine.end(), [](double bits) { return bits == 0; });
  expect_distribution(call + ", of 0", zero, uniform_cdf,
                      {"a scrambled value is uniform", one_alpha}, hints);
  expect_distribution(call + ", bits 33 to 52 of it", fine, uniform_cdf,
                      {"the last 20 bits of a scrambled value are uniform", one_alpha},
                      {{}, of_32 ? "53 bits of a value are scrambled, not 32" : hints.otherwise});
  const double eighth = 0.125;
  expect_counts(call + ", how often bit 0, bit 1 behind 0 and bit 1 behind 1 were flipped together",
                flips, std::span(&eighth, 1),
                {"flips behind different strings are independent", one_alpha}, hints);
  expect_distribution(call + ", bits 1 to 52 of 0 against those of 1/2", apart, uniform_cdf,
                      {"flips behind different strings are independent", one_alpha}, hints);
  expect_distribution(
      fmt::format("{}, bits 20 to 52 of {:.17g} against those of {:.17g}", call, x[2], x[3]),
      deep_apart, uniform_cdf, {"flips behind different long strings are independent", one_alpha},
      hints);
}

CHECK_CASE("5.8 all 64 bits of the seed count", "[5.8][points:2][edge]") {
  Rng rng = check_rng();
  const std::uint64_t seed = rng();
  std::vector<std::uint64_t> seeds{seed};
  for (int bit = 0; bit < 64; ++bit) seeds.push_back(seed ^ std::uint64_t{1} << bit);
  const auto flipped = MEASURE(owen_scramble, {0.25}, seeds);
  const auto& of_seed = flipped.exactly(65, unit);
  for (std::size_t bit = 0; bit < 64; ++bit) {
    expect_that(of_seed[0] != of_seed[1 + bit],
                fmt::format("{} gave {:.17g} twice: bit {} of the seed does nothing", flipped.call,
                            of_seed[0], bit),
                "different numbers for different seeds", "all 64 bits of the seed are hashed",
                bit >= 32 ? "was the seed cut to 32 bits?" : "");
  }
  // Neighbouring seeds, as axes and pixels have them, are strangers to each other.
  constexpr std::size_t pairs = 6400;
  std::vector<std::uint64_t> row(2 * pairs);
  std::iota(row.begin(), row.end(), rng() >> 1);
  const auto measured = MEASURE(owen_scramble, {0, 0.625}, row);
  const SetsOfPoints got(measured.exactly(4 * pairs, unit), 2, 1);
  std::vector<double> zeros, crossed;
  std::size_t doubled = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    const auto here = got.column(2 * i, 0), next = got.column(2 * i + 1, 0);
    zeros.insert(zeros.end(), {here[0], next[0]});
    crossed.push_back(static_cast<double>(bits_of(here[1]) ^ bits_of(next[1])) * half_ulp);
    doubled += std::abs(next[0] - wrapped(2 * here[0])) < 1e-9 ? 1u : 0u;
  }
  const Hints hints{{},
                    doubled == pairs
                        ? "of 0, the next seed's number is twice this one's: seed + level is the "
                          "same for a seed and the next level, and for the next seed and this "
                          "level; hash the seed before the level is added"
                        : "seeds that differ a little give flips that are not independent: "
                          "are all bits of the seed mixed before they meet the bits of a value?"};
  expect_even_pairs(measured.call + ", 0 scrambled by a seed and by the next", zeros,
                    {"neighbouring seeds give independent numbers", one_alpha}, hints);
  expect_distribution(measured.call + ", flips by a seed against those by the next", crossed,
                      uniform_cdf, {"neighbouring seeds give independent flips", one_alpha}, hints);
}

}  // namespace
}  // namespace mc::checks
