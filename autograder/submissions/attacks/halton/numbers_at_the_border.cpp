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
