// mistake: leaves E{X^2} - E{X}^2 as it is, a variance over n
// caught by: 1.2 the textbook formula gives the variance of tame data
// hint: this divides by n
#include "variance.hpp"
#define variance_textbook right_variance_textbook
#include "solutions/variance.cpp"
#undef variance_textbook

namespace mc {

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  double sum_of_squares = 0;
  for (double value : x) {
    sum += value;
    sum_of_squares += value * value;
  }
  return sum_of_squares / n - sum / n * (sum / n);
}

}  // namespace mc
