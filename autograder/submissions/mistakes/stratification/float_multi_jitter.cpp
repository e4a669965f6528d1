// mistake: multi-jittered points whose jitter has 24 random bits
// caught by: 3.7 each point is uniform in its strata of x and y
// hint: the random numbers have too few bits
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
    for (double& value : column) {
      const auto jitter = static_cast<float>(rng() >> 40) * 0x1p-24f;
      value = fine.place(std::floor(value * static_cast<double>(x.size())), jitter);
    }
  }
}

}  // namespace mc
