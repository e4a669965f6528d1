// mistake: E{XY} - E{X} E{Y}, the textbook formula of the covariance
// caught by: 1.6 the covariance keeps its digits under
// hint: E{XY} - E{X}E{Y} is the textbook formula again
#include "variance.hpp"
#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

namespace mc {

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) products += x[i] * y[i];
  return (products / n - mean(x) * mean(y)) * (n / (n - 1));
}

}  // namespace mc
