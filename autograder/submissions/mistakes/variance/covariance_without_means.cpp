// mistake: E{XY}, from which nothing is subtracted
// caught by: 1.6 the covariance of pairs
// caught by: 1.6 the covariance keeps its digits under
// caught by: 1.6 the covariance keeps its digits at any
// hint: the means are not in it
#include "variance.hpp"
#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

namespace mc {

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (x.size() < 2) return nan;
  double products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) products += x[i] * y[i];
  return products / static_cast<double>(x.size() - 1);
}

}  // namespace mc
