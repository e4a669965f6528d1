// Mistakes in task 5.3.
#include "halton.hpp"

#define halton right_halton
#define primes right_primes
#include "solutions/halton.cpp"
#undef halton
#undef primes

// mistake: keeps the first index of Halton points in 32 bits
// hint: truncated to 32 bits
namespace mc::halton_first_of_32_bits {
void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size(), last_index);
  right_halton(points, static_cast<std::uint32_t>(first));
}
}  // namespace mc::halton_first_of_32_bits

// mistake: starts at index first + 1
// hint: this begins one index too late
namespace mc::halton_from_one {
void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size() + 1, last_index);
  right_halton(points, first + 1);
}
}  // namespace mc::halton_from_one

// mistake: takes primes from a table of 31 and starts again at its end
// hint: these are in base 2 instead of
namespace mc::halton_of_31_primes {
void halton(PointSet& points, std::uint64_t first) {
  require_indices(first, points.size(), last_index);
  const auto table = primes(31);
  for (std::size_t d = 0; d < points.dims(); ++d) {
    radical_inverses(table[d % table.size()], first, points.column(d));
  }
}
}  // namespace mc::halton_of_31_primes

// mistake: uses base 2 for every axis
// hint: these are in base 2 instead of
namespace mc::one_base_for_all {
void halton(PointSet& points, std::uint64_t first) {
  for (std::size_t d = 0; d < points.dims(); ++d) radical_inverses(2, first, points.column(d));
}
}  // namespace mc::one_base_for_all

// mistake: counts 1 as the first prime
// hint: 1 is not prime
namespace mc::one_is_prime {
std::vector<unsigned> primes(std::size_t count) {
  auto found = right_primes(count);
  found.insert(found.begin(), 1);
  found.resize(count);
  return found;
}
}  // namespace mc::one_is_prime
