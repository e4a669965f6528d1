// Mistakes in task 5.10.
#include "halton.hpp"

#include <cmath>

#define lattice right_lattice
#define tent right_tent
#include "solutions/halton.cpp"
#undef lattice
#undef tent

// mistake: the same number for all axes: all points are on the diagonal
// hint: this is i / N on every axis
namespace mc::lattice_on_the_diagonal {
void lattice(PointSet& points, std::uint64_t seed) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    std::size_t i = 0;
    for (double& x : points.column(d))
      x = static_cast<double>(i++) / static_cast<double>(points.size());
  }
  Rng rng(seed);
  random_shift(points, rng);
}
}  // namespace mc::lattice_on_the_diagonal

// mistake: multiples of a rounded z / N, which lose the digits that i z has
// hint: compute i z modulo N in integers
namespace mc::multiples_of_a_rounded_step {
void lattice(PointSet& points, std::uint64_t seed) {
  Rng rng(seed);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto x = points.column(d);
    const double step = static_cast<double>(lattice_vector.at(d)) / static_cast<double>(x.size());
    const double shift = static_cast<double>(rng() >> 11) * 0x1p-53;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double value = static_cast<double>(i) * step + shift;
      x[i] = value - std::floor(value);
    }
  }
}
}  // namespace mc::multiples_of_a_rounded_step

// mistake: computes i z in 32 bits
// hint: i z needs more than 32 bits
namespace mc::products_in_32_bits {
void lattice(PointSet& points, std::uint64_t seed) {
  if (points.dims() > lattice_vector.size())
    throw std::invalid_argument("points: more than 16 dimensions");
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    const auto x = points.column(d);
    const auto z = static_cast<std::uint32_t>(lattice_vector[d]);
    for (std::uint32_t i = 0; i < n; ++i) x[i] = static_cast<double>(i * z % n) / n;
  }
  Rng rng(seed);
  random_shift(points, rng);
}
}  // namespace mc::products_in_32_bits

// mistake: uses only the lower 32 bits of the seed
// hint: the shift does not depend on all 64 bits of the seed
namespace mc::shift_by_half_of_the_seed {
void lattice(PointSet& points, std::uint64_t seed) {
  right_lattice(points, static_cast<std::uint32_t>(seed));
}
}  // namespace mc::shift_by_half_of_the_seed

// mistake: doubles modulo 1 in place of folding, which only makes two copies of a jump
// hint: fold instead
namespace mc::doubled_not_folded {
void tent(std::span<double> column) {
  for (double& x : column) x = x < 0.5 ? 2 * x : 2 * x - 1;
}
}  // namespace mc::doubled_not_folded
