// mistake: the points of 3.1 are shuffled; they are due in order
// caught by: 3.1 one point in each stratum and in order
// caught by: 3.1 no point leaves its stratum whatever the bits
// hint: they do not come in order
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  right_stratified_1d(x, rng);
  mc::shuffle(x, rng);
}

}  // namespace mc
