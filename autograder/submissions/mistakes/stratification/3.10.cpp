// Mistakes in task 3.10.
#include "stratification.hpp"

#define stratified_1d right_stratified_1d
#include "solutions/stratification.cpp"
#undef stratified_1d

// mistake: makes the random numbers of the first 2^16 points only, and uses them again
// hint: random numbers repeat
namespace mc::one_block_of_numbers {
void stratified_1d(std::span<double> x, Rng& rng) {
  constexpr std::size_t most = std::size_t{1} << 16;
  right_stratified_1d(x, rng);
  const auto n = static_cast<double>(x.size());
  for (std::size_t i = most; i < x.size(); ++i) {
    const double u = x[i - most] * n - static_cast<double>(i - most);
    const double low = static_cast<double>(i) / n, high = static_cast<double>(i + 1) / n;
    x[i] = std::clamp((static_cast<double>(i) + u) / n, low, std::nextafter(high, 0.0));
  }
}
}  // namespace mc::one_block_of_numbers
