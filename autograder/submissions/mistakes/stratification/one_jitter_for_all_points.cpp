// mistake: one random number moves all multi-jittered points along x, one along y
// caught by: 3.7 each point is uniform in its strata of x and y
// caught by: 3.7 a sum is estimated as in one dimension
// hint: the same random numbers come again
#include "stratification.hpp"

#include <cmath>

#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  right_multi_jittered(x, y, grid, rng);
  const Strata fine(x.size());
  for (const auto column : {x, y}) {
    const double u = to_unit(rng());
    for (double& value : column) {
      value = fine.place(std::floor(value * static_cast<double>(x.size())), u);
    }
  }
}

}  // namespace mc
