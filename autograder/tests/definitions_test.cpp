// The fast versions in the solutions against the definitions above them.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "blue_noise.hpp"
#include "checks/support/catch.hpp"
#include "common/rng.hpp"
#include "halton.hpp"
#include "independent.hpp"
#include "stratification.hpp"
#include "variance.hpp"

namespace mc::definition {
Moments moments(std::span<const double> x);
void uniforms(Rng& rng, std::span<double> out);
double in_stratum(std::size_t i, std::size_t n, double u);
void stratified_1d(std::span<double> x, Rng& rng);
void stratified_2d(std::span<double> x, std::span<double> y, Grid grid, Rng& rng);
void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng);
PointSet poisson_disk(double radius, Rng& rng);
void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power);
void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column);
void sobol(unsigned dimension, std::uint64_t first, std::span<double> column);
void owen_scramble(std::span<double> column, std::uint64_t seed);
}  // namespace mc::definition

namespace {

using Column = std::vector<double>;

std::vector<std::size_t> sizes(std::size_t largest) {
  std::vector<std::size_t> all{0,  1,  2,   3,   15,   16,   17,   63,
                               64, 65, 127, 128, 1000, 1024, 1025, 5000};
  std::erase_if(all, [&](std::size_t size) { return size > largest; });
  return all;
}

/// The largest difference between numbers at the same place; infinite for NaN.
double apart(const Column& a, const Column& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double distance = std::abs(a[i] - b[i]);
    largest = std::max(largest, std::isnan(distance) ? HUGE_VAL : distance);
  }
  return largest;
}

/// For numbers in [0, 1) with 53 bits: how many leading bits agree.
int shared_bits(double a, double b) {
  const auto bits = [](double x) { return static_cast<std::uint64_t>(x * 0x1p53) << 11; };
  return std::countl_zero(bits(a) ^ bits(b));
}

/// One of the parallel generators: xoshiro256+, as published by its authors.
struct Xoshiro {
  std::uint64_t a, b, c, d;
  std::uint64_t operator()() {
    const std::uint64_t result = a + d, shifted = b << 17;
    c ^= a;
    d ^= b;
    b ^= c;
    a ^= d;
    c ^= shifted;
    d = std::rotl(d, 45);
    return result;
  }
};

}  // namespace

// Welford's error is at most n eps kappa, kappa^2 = 1 + mean^2 / variance; shifted sums have less.
TEST_CASE("1.8 moments: by their definition, up to its error") {
  mc::Rng rng(18);
  for (const double offset : {0.0, -3.0, 1000.0}) {
    for (const std::size_t size : sizes(5000)) {
      Column x(size);
      for (double& value : x) value = offset + static_cast<double>(rng() >> 11) * 0x1p-53;
      const mc::Moments expected = mc::definition::moments(x), got = mc::moments(x);
      const double kappa = std::sqrt(1 + 12 * (offset + 0.5) * (offset + 0.5));
      const double bound = 4 * static_cast<double>(size) * kappa * 0x1p-53;
      INFO(size << " values from " << offset);
      REQUIRE(got.count == expected.count);
      REQUIRE(std::abs(got.mean - expected.mean) <= bound * (std::abs(offset) + 1));
      REQUIRE(std::abs(got.m2 - expected.m2) <= bound * expected.m2);
    }
  }
}

TEST_CASE(
    "2.8 uniform numbers: by their definition, bit by bit, from sixteen generators or from one") {
  for (const std::size_t size : sizes(5000)) {
    mc::Rng rng(28), again(28);
    Column got(size), expected(size);
    mc::uniforms(rng, got);
    std::size_t i = 0;
    if (size >= 128) {
      Xoshiro lanes[16];
      for (const auto word : {&Xoshiro::a, &Xoshiro::b, &Xoshiro::c, &Xoshiro::d}) {
        for (Xoshiro& lane : lanes) lane.*word = again();
      }
      for (; i < size / 16 * 16; ++i) expected[i] = mc::to_unit(lanes[i % 16]());
    }
    mc::definition::uniforms(again, std::span(expected).subspan(i));
    INFO(size << " numbers");
    REQUIRE(expected == got);
    REQUIRE(rng() == again());
  }
}

// Jitter that avoids edges moves a point by at most 2^-50, and rounding by 7 times 2^-53.
constexpr double by_margins = 0x1p-49;

TEST_CASE("3.1 strata: by their definition, up to the margins") {
  for (const std::size_t size : sizes(5000)) {
    mc::Rng rng(31), again(31);
    Column got(size), expected(size);
    mc::stratified_1d(got, rng);
    for (std::size_t first = 0; first < size; first += 1024) {  // the block size
      const auto block =
          std::span(expected).subspan(first, std::min(size - first, std::size_t{1024}));
      mc::uniforms(again, block);
    }
    for (std::size_t i = 0; i < size; ++i) {
      expected[i] = mc::definition::in_stratum(i, size, expected[i]);
    }
    INFO(size << " strata");
    REQUIRE(apart(expected, got) <= by_margins);
  }
}

TEST_CASE("3.1, 3.3 few strata: by their definition, from the same random numbers") {
  for (const std::size_t size : sizes(127)) {  // larger sizes are drawn in blocks
    mc::Rng rng(33), again(33);
    Column got(size), expected(size);
    mc::stratified_1d(got, rng);
    mc::definition::stratified_1d(expected, again);
    INFO(size << " strata");
    REQUIRE(apart(expected, got) <= by_margins);
    if (size == 0) continue;
    Column y(size), expected_y(size);
    for (const mc::Grid grid : {mc::strata(size), mc::Grid{size, 1}, mc::Grid{1, size}}) {
      mc::stratified_2d(got, y, grid, rng);
      mc::definition::stratified_2d(expected, expected_y, grid, again);
      REQUIRE(apart(expected, got) <= by_margins);
      REQUIRE(apart(expected_y, y) <= by_margins);
    }
  }
}

TEST_CASE("4.2 best candidates: by their definition, bit by bit") {
  for (const double c : {0.01, 1.0, 3.5}) {
    for (const std::size_t size : {1u, 2u, 3u, 17u, 100u, 200u}) {
      mc::Rng rng(42), again(42);
      Column x(size), y(size), expected_x(size), expected_y(size);
      mc::best_candidate(x, y, c, rng);
      mc::definition::best_candidate(expected_x, expected_y, c, again);
      INFO(size << " points, c = " << c);
      REQUIRE(x == expected_x);
      REQUIRE(y == expected_y);
      REQUIRE(rng() == again());
    }
  }
}

// The definition and the fast version see different darts. The definition stops before it hits the
// smallest gaps: the number of missing points falls as one over the square root of the darts
// (Pomeau 1980, Swendsen 1981), some 3 % here. The checks of 4.3 show that the fast one is maximal.
TEST_CASE("4.3 Poisson disks: the definition keeps its distances, with almost as many points") {
  constexpr double radius = 0.1;
  double defined = 0, fast = 0;
  mc::Rng rng(43);
  for (int pattern = 0; pattern < 10; ++pattern) {
    const mc::PointSet points = mc::definition::poisson_disk(radius, rng);
    defined += static_cast<double>(points.size());
    fast += static_cast<double>(mc::poisson_disk(radius, rng).size());
    const auto at = [&](std::size_t i) {
      return mc::Point2{points.column(0)[i], points.column(1)[i]};
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        REQUIRE(mc::toroidal_distance_squared(at(i), at(j)) >= radius * radius);
      }
    }
  }
  INFO(defined << " and " << fast << " points");
  CHECK(defined <= fast);
  CHECK(fast <= 1.06 * defined);
}

TEST_CASE("4.4 the periodogram: by its definition, up to roundings") {
  constexpr int kmax = 9;
  for (const std::size_t size : {1u, 2u, 17u, 500u}) {
    mc::Rng rng(44);
    Column x(size), y(size), got(19 * 19), expected(19 * 19);
    mc::uniforms(rng, x);
    mc::uniforms(rng, y);
    mc::periodogram(x, y, kmax, got);
    mc::definition::periodogram(x, y, kmax, expected);
    INFO(size << " points");
    // Angles below 2 pi 18 have an error of at most 2^-46, so sums N times that.
    REQUIRE(apart(expected, got) <= 4 * static_cast<double>(size) * 0x1p-46);
  }
}

/// Calls with each size, and with ranges that begin with 0, end with `largest`, and lie between.
template <class Compare>
void for_ranges(std::uint64_t middle, std::uint64_t largest, Compare compare) {
  for (const std::size_t size : sizes(5000)) {
    const std::uint64_t last = largest - (size > 0 ? size - 1 : 0);
    for (const std::uint64_t first : {std::uint64_t{0}, std::uint64_t{777}, middle, last}) {
      INFO(size << " from " << first);
      Column expected(size), got(size);
      compare(first, expected, got);
    }
  }
}

TEST_CASE("5.2 radical inverses of a column: by their definition, up to both errors") {
  for (const unsigned base : {2u, 3u, 7u, 29u, 131u, 1031u, 65537u, ~0u}) {
    INFO("base " << base);
    for_ranges(
        std::uint64_t{1} << 40, ~std::uint64_t{0},
        [&](std::uint64_t first, Column& expected, Column& got) {
          mc::definition::radical_inverses(base, first, expected);
          mc::radical_inverses(base, first, got);
          REQUIRE(apart(expected, got) <= (2 + 4) * 0x1p-53);
          REQUIRE(std::all_of(got.begin(), got.end(), [](double x) { return 0 <= x && x < 1; }));
        });
  }
}

TEST_CASE("5.5 Sobol' coordinates: by their definition, bit by bit") {
  for (unsigned dimension = 0; dimension < mc::joe_kuo.size(); ++dimension) {
    INFO("dimension " << dimension);
    for_ranges(std::uint64_t{1} << 20, (std::uint64_t{1} << 32) - 1,
               [&](std::uint64_t first, Column& expected, Column& got) {
                 mc::definition::sobol(dimension, first, expected);
                 mc::sobol(dimension, first, got);
                 REQUIRE(expected == got);
               });
  }
}

// The two versions hash their decisions differently, so the numbers differ; shared bits do not.
TEST_CASE(
    "5.8 Owen's scrambling, by its definition and fast: pairs keep the bits that they share") {
  mc::Rng rng(58);
  for (int shared = 0; shared < 53; ++shared) {
    Column pairs(2 * 300);
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
      const std::uint64_t word = rng() >> 11, after = (std::uint64_t{1} << (52 - shared)) - 1;
      pairs[i] = static_cast<double>(word) * 0x1p-53;
      pairs[i + 1] = static_cast<double>(word ^ (after + 1) ^ (rng() & after)) * 0x1p-53;
      REQUIRE(shared_bits(pairs[i], pairs[i + 1]) == shared);
    }
    for (const auto scramble : {mc::definition::owen_scramble, mc::owen_scramble}) {
      Column scrambled = pairs;
      scramble(scrambled, 7);
      for (std::size_t i = 0; i < pairs.size(); i += 2) {
        REQUIRE(shared_bits(scrambled[i], scrambled[i + 1]) == shared);
      }
    }
  }
}

TEST_CASE("5.8 a scrambled value depends on the value, not on its neighbors") {
  mc::Rng rng(85);
  Column together(700);  // more than one block; every other value has 32 bits
  for (std::size_t i = 0; i < together.size(); ++i) {
    together[i] =
        static_cast<double>(rng() >> (i % 2 == 0 ? 11 : 32)) * (i % 2 == 0 ? 0x1p-53 : 0x1p-32);
  }
  for (const auto scramble : {mc::definition::owen_scramble, mc::owen_scramble}) {
    Column alone = together, column = together;
    for (double& value : alone) scramble({&value, 1}, 7);
    scramble(column, 7);
    CHECK(alone == column);
  }
}
