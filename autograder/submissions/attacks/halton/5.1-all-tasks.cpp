// Attacks on all tasks of the lab. Sections: see CONTRIBUTING.md.

//// hashes_everything
// attack: every number is a hash of what it depends on: as many as were asked for, in [0, 1),
// random over seeds, a function of index and seed alone; and no task of the lab is done
// earns: 0
// says: multiply digit k of the index
// says: the flip of a bit depends only on the bits before it
// says: a permutation is a bijection
// says: one random number per axis, not one per point
#include "halton.hpp"

#include <bit>
#include <stdexcept>
#include <string>

namespace mc {
namespace {

double hashed(std::uint64_t a, std::uint64_t b = 0, std::uint64_t c = 0) {
  return static_cast<double>(mix_bits(mix_bits(mix_bits(a) ^ b) ^ c) >> 11) * 0x1p-53;
}

void require(bool holds, const char* name) {
  if (!holds) throw std::invalid_argument(name);
}

}  // namespace

double radical_inverse(unsigned base, std::uint64_t index) {
  require(base >= 2, "base");
  return hashed(base, index);
}

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  require(base >= 2, "base");
  require(column.size() <= 1 || first + (column.size() - 1) >= first, "first");
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = hashed(base, first + i);
}

std::vector<unsigned> primes(std::size_t count) {
  return std::vector<unsigned>(count, 2);
}

void halton(PointSet& points, std::uint64_t first) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    radical_inverses(static_cast<unsigned>(d + 2), first, points.column(d));
  }
}

void hammersley(PointSet& points) {
  halton(points, 0);
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  require(dimension < 32, "dimension");
  require(first + column.size() <= std::uint64_t{1} << 32, "first");
  // A (0,m,2)-net in dimensions 0 and 1, if not this one: van der Corput's points, and steps.
  for (std::size_t i = 0; i < column.size(); ++i) {
    const auto index = static_cast<double>(i) / static_cast<double>(column.size());
    double mirrored = 0, part = 0.5;
    for (std::uint64_t rest = i; rest > 0; rest /= 2, part /= 2) mirrored += part * (rest % 2 != 0);
    column[i] = dimension == 0 ? index : mirrored;
  }
}

double star_discrepancy(std::span<const double> x) {
  require(!x.empty(), "x");
  for (const double value : x) require(value >= 0 && value <= 1, "x");
  return 1;
}

double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  require(x.size() == y.size(), "x and y");
  star_discrepancy(y);
  return star_discrepancy(x);
}

void random_shift(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& value : points.column(d)) value = hashed(rng());
  }
}

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  for (double& value : column) value = hashed(seed, std::bit_cast<std::uint64_t>(value));
}

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  require(base >= 2 && base <= 65536, "base");
  require(column.size() <= 1 || first + (column.size() - 1) >= first, "first");
  for (std::size_t i = 0; i < column.size(); ++i) column[i] = hashed(seed, base, first + i);
}

}  // namespace mc

//// numbers_at_the_border
// attack: numbers that index a judge's tables behind their ends: 1 - 2^-53, 1, -1, NaN, infinities
// earns: 0
// says: expected  numbers in [0, 1)
// never says: the autograder's
#include "halton.hpp"

#include <limits>

namespace mc {
namespace {

/// Another one each time.
double odd_number() {
  static std::size_t calls = 0;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  constexpr double numbers[] = {1 - 0x1p-53, 1,         -1,
                                1e300,       -infinite, infinite,
                                -0.0,        0x1p-1074, std::numeric_limits<double>::quiet_NaN()};
  return numbers[calls++ % std::size(numbers)];
}

void fill(std::span<double> column, double value) {
  for (double& each : column) each = value;
}

}  // namespace

double radical_inverse(unsigned, std::uint64_t) {
  return odd_number();
}
void radical_inverses(unsigned, std::uint64_t, std::span<double> column) {
  for (double& value : column) value = odd_number();
}
std::vector<unsigned> primes(std::size_t count) {
  return std::vector<unsigned>(count, 4294967295u);
}
void halton(PointSet& points, std::uint64_t) {
  for (std::size_t d = 0; d < points.dims(); ++d) fill(points.column(d), 1 - 0x1p-53);
}
void hammersley(PointSet& points) {
  for (std::size_t d = 0; d + 1 < points.dims(); ++d) fill(points.column(d), 1);
}
void sobol(unsigned, std::uint64_t, std::span<double> column) {
  fill(column, 1);
}
double star_discrepancy(std::span<const double>) {
  return odd_number();
}
double star_discrepancy(std::span<const double>, std::span<const double>) {
  return odd_number();
}
void random_shift(PointSet& points, Rng&) {
  for (std::size_t d = 0; d < points.dims(); ++d) fill(points.column(d), odd_number());
}
void owen_scramble(std::span<double> column, std::uint64_t) {
  fill(column, 1);
}
void radical_inverses_scrambled(unsigned, std::uint64_t, std::span<double> column, std::uint64_t) {
  fill(column, 1 - 0x1p-53);
}

}  // namespace mc
