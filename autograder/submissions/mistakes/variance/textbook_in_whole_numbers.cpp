// mistake: adds the values up with std::accumulate(…, 0), in int
// caught by: 1.2 the textbook formula gives
// hint: added up in whole numbers
#include <numeric>
#include "variance.hpp"
#define variance_textbook right_variance_textbook
#include "solutions/variance.cpp"
#undef variance_textbook

namespace mc {

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double sum_of_squares = 0;
  for (double value : x) sum_of_squares += value * value;
  const double mean = std::accumulate(x.begin(), x.end(), 0) / n;
  return (sum_of_squares / n - mean * mean) * (n / (n - 1));
}

}  // namespace mc
