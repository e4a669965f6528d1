// mistake: every block of a long pattern starts with the same random numbers
// caught by: 3.9 fast numbers are as independent as slow ones
// hint: the same random numbers come again and again
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const Strata strata(x.size());
  const Rng start(rng());
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const auto block = x.subspan(first, std::min(block_size, x.size() - first));
    Rng same = start;
    for (double& u : block) u = to_unit(same());
    move_into(strata, first, block);
  }
}

}  // namespace mc
