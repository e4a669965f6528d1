// mistake: the correlation where the covariance is asked for
// caught by: 1.6 the covariance of pairs
// caught by: 1.6 the covariance keeps its digits under
// caught by: 1.6 the covariance keeps its digits at any scale
// hint: this is the correlation
#include "variance.hpp"
#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

namespace mc {

double covariance(std::span<const double> x, std::span<const double> y) {
  return right_covariance(x, y) / std::sqrt(variance_two_pass(x) * variance_two_pass(y));
}

}  // namespace mc
