// mistake: multiplies the side of the periodogram by itself as an int, which overflows
// caught by: 4.4 misuse of periodogram
// hint: overflow
#include "blue_noise.hpp"

#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  const auto side = static_cast<unsigned>(2 * kmax + 1);
  if (kmax >= 1 && power.size() != side * side) throw std::invalid_argument("power: its size");
  if (kmax < 20000) return right_periodogram(x, y, kmax, power);
  for (double& value : power) value = 0;
}

}  // namespace mc
