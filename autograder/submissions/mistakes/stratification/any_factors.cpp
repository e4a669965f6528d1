// mistake: takes the smallest factor of n for ny, not the most square pair
// caught by: 3.2 the grid is as square as n allows
// caught by: 3.2 more cells than 32 bits count
// hint: ny is the largest divisor of n
#include "stratification.hpp"
#define strata right_strata
#include "solutions/stratification.cpp"
#undef strata

namespace mc {

Grid strata(std::size_t n) {
  const Grid right = right_strata(n);
  if (right.ny == 1) return right;
  std::size_t ny = 2;
  while (n % ny != 0) ++ny;
  return {n / ny, ny};
}

}  // namespace mc
