// mistake: takes floor(sqrt(n)) rows whether they divide n or not
// caught by: 3.2 the grid is as square as n allows
// caught by: 3.2 a prime number of cells is a row
// hint: a stratum too few leaves points out
#include "stratification.hpp"

#include <cmath>

#define strata right_strata
#include "solutions/stratification.cpp"
#undef strata

namespace mc {

Grid strata(std::size_t n) {
  const Grid right = right_strata(n);  // throws for n = 0
  const auto ny = static_cast<std::size_t>(std::sqrt(static_cast<double>(right.nx * right.ny)));
  return {n / ny, ny};
}

}  // namespace mc
