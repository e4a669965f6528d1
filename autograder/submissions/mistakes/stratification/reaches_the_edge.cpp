// mistake: (i + u) / N is rounded up to the edge of the next stratum
// caught by: 3.1 no point leaves its stratum whatever the bits
// hint: it was rounded up to 1
#include "stratification.hpp"
#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = (static_cast<double>(i) + to_unit(rng())) / n;
  }
}

}  // namespace mc
