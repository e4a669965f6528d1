// Lab 5 · Halton and quasi-Monte Carlo. labs/5-halton/halton.hpp states what each function
// promises, and labs/5-halton/README.md is the handout. Write the tasks in any order and check them
// with
//
//   ./lab check halton              the whole lab
//   ./lab check halton --only 5.1   one task

#include "halton.hpp"

#include <stdexcept>

#include "common/todo.hpp"

namespace mc {

/// A finished example: the digits of the index, the last one first; none for 0.
[[maybe_unused]] static std::vector<unsigned> digits(unsigned base, std::uint64_t index) {
  if (base < 2) throw std::invalid_argument("base: must be at least 2");
  std::vector<unsigned> result;
  for (; index > 0; index /= base) result.push_back(static_cast<unsigned>(index % base));
  return result;
}

double radical_inverse(unsigned base, std::uint64_t index) {
  throw todo("5.1");  // TODO(5.1): the digits of the index, mirrored at the radix point
}

void radical_inverses(unsigned base, std::uint64_t first, std::span<double> column) {
  throw todo("5.2");  // TODO(5.2): consecutive indices, fast (a stretch task)
}

std::vector<unsigned> primes(std::size_t count) {
  throw todo("5.3");  // TODO(5.3): 2, 3, 5, …
}

void halton(PointSet& points, std::uint64_t first) {
  throw todo("5.3");  // TODO(5.3): a radical inverse in one prime for each axis
}

void hammersley(PointSet& points) {
  throw todo("5.4");  // TODO(5.4): i/N, then radical inverses in 2, 3, 5, …
}

void sobol(unsigned dimension, std::uint64_t first, std::span<double> column) {
  throw todo("5.5");  // TODO(5.5): the XOR of the direction numbers of the index's bits
}

double star_discrepancy(std::span<const double> x) {
  throw todo("5.6");  // TODO(5.6): sort; the worst interval ends at a point, open or closed
}

double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  throw todo("5.6");  // TODO(5.6): boxes that end at points or at 1, open and closed
}

void random_shift(PointSet& points, Rng& rng) {
  throw todo("5.7");  // TODO(5.7): one random number for each axis; wrap around at 1
}

void owen_scramble(std::span<double> column, std::uint64_t seed) {
  throw todo("5.8");  // TODO(5.8): flip each bit by a hash of the seed and the bits before it
}

void radical_inverses_scrambled(unsigned base, std::uint64_t first, std::span<double> column,
                                std::uint64_t seed) {
  throw todo("5.9");  // TODO(5.9): a random permutation of the digits at each position
}

void lattice(PointSet& points, std::uint64_t seed) {
  throw todo("5.10");  // TODO(5.10): i z / N modulo 1, shifted as in 5.7 (a stretch task)
}

void tent(std::span<double> column) {
  throw todo("5.10");  // TODO(5.10): fold [0, 1) in the middle
}

}  // namespace mc
