// mistake: looks for the factor by k * k in 32 bits, which is never above a larger n
// caught by: 3.2 more cells than 32 bits count
// hint: k * k in 32 bits
#include "stratification.hpp"
#define strata right_strata
#include "solutions/stratification.cpp"
#undef strata

namespace mc {

Grid strata(std::size_t n) {
  if (n == 0) throw std::invalid_argument("n: there are no strata");
  unsigned best = 1;
  for (unsigned k = 1; k * k <= n; ++k) {
    if (k != 0 && n % k == 0) best = k;
  }
  return {n / best, best};
}

}  // namespace mc
