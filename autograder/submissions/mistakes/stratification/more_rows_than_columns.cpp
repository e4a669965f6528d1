// mistake: nx and ny of the grid have changed places
// caught by: 3.2 the grid is as square as n allows
// caught by: 3.2 a prime number of cells is a row
// caught by: 3.2 more cells than 32 bits count
// hint: nx is the larger one
#include "stratification.hpp"
#define strata right_strata
#include "solutions/stratification.cpp"
#undef strata

namespace mc {

Grid strata(std::size_t n) {
  const Grid grid = right_strata(n);
  return {grid.ny, grid.nx};
}

}  // namespace mc
