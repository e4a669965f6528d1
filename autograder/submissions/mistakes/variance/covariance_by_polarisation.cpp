// mistake: takes the covariance from Var{X + Y}, in which the larger variance drowns the smaller
// caught by: 1.6 the covariance keeps its digits at any scale
// hint: Is it taken from Var{X + Y}?
#include "variance.hpp"
#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

namespace mc {

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  std::vector<double> sum(x.begin(), x.end());
  for (std::size_t i = 0; i < x.size(); ++i) sum[i] += y[i];
  return (variance_two_pass(sum) - variance_two_pass(x) - variance_two_pass(y)) / 2;
}

}  // namespace mc
