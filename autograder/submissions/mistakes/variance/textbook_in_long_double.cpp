// mistake: a wider type saves the textbook formula from what it is here to show
// caught by: 1.2 the textbook formula loses everything under a large mean
// hint: or a wider type
#include "variance.hpp"
#define variance_textbook right_variance_textbook
#include "solutions/variance.cpp"
#undef variance_textbook

namespace mc {

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<long double>(x.size());
  long double sum = 0;
  long double sum_of_squares = 0;
  for (long double value : x) {
    sum += value;
    sum_of_squares += value * value;
  }
  return static_cast<double>((sum_of_squares / n - sum / n * (sum / n)) * (n / (n - 1)));
}

}  // namespace mc
