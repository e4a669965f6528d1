// mistake: refuses what is no grid by std::out_of_range
// caught by: 3.7 what is no grid of these points is refused
// caught by: 3.7 the refusals name the argument
// hint: misuse throws std::invalid_argument
#include "stratification.hpp"
#define multi_jittered right_multi_jittered
#include "solutions/stratification.cpp"
#undef multi_jittered

namespace mc {

void multi_jittered(std::span<double> x, std::span<double> y, Grid grid, Rng& rng) {
  try {
    right_multi_jittered(x, y, grid, rng);
  } catch (const std::invalid_argument& wrong) {
    throw std::out_of_range(wrong.what());
  }
}

}  // namespace mc
