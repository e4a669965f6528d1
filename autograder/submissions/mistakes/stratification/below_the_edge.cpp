// mistake: multiplies by 1 / N, rounded, and falls below the lower edge
// caught by: 3.1 no point leaves its stratum whatever the bits
// hint: it was rounded down below the edge
#include "stratification.hpp"

#include <cmath>

#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

namespace mc {

void stratified_1d(std::span<double> x, Rng& rng) {
  const auto n = static_cast<double>(x.size());
  const double width = 1 / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::min((static_cast<double>(i) + to_unit(rng())) * width,
                    std::nextafter(static_cast<double>(i + 1) / n, 0.0));
  }
}

}  // namespace mc
