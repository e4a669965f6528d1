// Mistakes in task 3.2.
#include "stratification.hpp"

#include <cmath>

#define strata right_strata
#include "solutions/stratification.cpp"
#undef strata

// mistake: uses the smallest factor of n for ny, not the most square pair
// hint: ny is the largest divisor of n
namespace mc::any_factors {
Grid strata(std::size_t n) {
  const Grid right = right_strata(n);
  if (right.ny == 1) return right;
  std::size_t ny = 2;
  while (n % ny != 0) ++ny;
  return {n / ny, ny};
}
}  // namespace mc::any_factors

// mistake: uses floor(sqrt(n)) rows even if they do not divide n
// hint: with fewer cells, points are left over
namespace mc::leaves_strata_out {
Grid strata(std::size_t n) {
  const Grid right = right_strata(n);  // throws for n = 0
  const auto ny = static_cast<std::size_t>(std::sqrt(static_cast<double>(right.nx * right.ny)));
  return {n / ny, ny};
}
}  // namespace mc::leaves_strata_out

// mistake: swaps nx and ny of the grid
// hint: nx must be the larger one
namespace mc::more_rows_than_columns {
Grid strata(std::size_t n) {
  const Grid grid = right_strata(n);
  return {grid.ny, grid.nx};
}
}  // namespace mc::more_rows_than_columns

// mistake: computes k * k in 32 bits, which never exceed a larger n
// hint: k * k overflows 32 bits
namespace mc::squares_in_32_bits {
Grid strata(std::size_t n) {
  if (n == 0) throw std::invalid_argument("n: must be positive");
  unsigned best = 1;
  for (unsigned k = 1; k * k <= n; ++k) {
    if (k != 0 && n % k == 0) best = k;
  }
  return {n / best, best};
}
}  // namespace mc::squares_in_32_bits

// mistake: searches up while k * k <= n, which never ends near 2^64
// hint: the search begins at 1: begin at sqrt(n) and go down
namespace mc::squares_in_64_bits {
Grid strata(std::size_t n) {
  if (n == 0) throw std::invalid_argument("n: must be positive");
  std::size_t best = 1;
  for (std::size_t k = 1; k * k <= n; ++k) {
    if (k != 0 && n % k == 0) best = k;
  }
  return {n / best, best};
}
}  // namespace mc::squares_in_64_bits
