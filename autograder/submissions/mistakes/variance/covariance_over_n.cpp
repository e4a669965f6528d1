// mistake: divides by n where a sample covariance divides by n - 1
// caught by: 1.6 the covariance of pairs
// caught by: 1.6 the covariance keeps its digits under
// caught by: 1.6 the covariance keeps its digits at any scale
// hint: this divides by n; a sample covariance divides by n - 1
#include "variance.hpp"
#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

namespace mc {

double covariance(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  return right_covariance(x, y) * ((n - 1) / n);
}

}  // namespace mc
