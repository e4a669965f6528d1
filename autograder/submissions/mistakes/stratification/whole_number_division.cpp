// mistake: divides i by N as whole numbers, which gives 0
// caught by: 3.1 one point in each stratum and in order
// caught by: 3.1 the error falls as N^-1.5
// caught by: 3.1 no point leaves its stratum whatever the bits
// hint: i / N of two whole numbers is 0
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = static_cast<double>(i / x.size()) + to_unit(rng()) / n;
  }
}

}  // namespace mc
