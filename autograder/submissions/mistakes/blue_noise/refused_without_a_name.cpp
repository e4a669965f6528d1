// mistake: says no more than that something is wrong
// caught by: 4.4 a refusal names the argument
// hint: say in the exception's text which argument is wrong
#include "blue_noise.hpp"
#define periodogram right_periodogram
#include "solutions/blue_noise.cpp"
#undef periodogram

namespace mc {

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  try {
    right_periodogram(x, y, kmax, power);
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument("bad input");
  }
}

}  // namespace mc
