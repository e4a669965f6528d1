// mistake: refuses lists of two sizes, and does not say what is wrong with them
// caught by: 1.6 the refusal names
// hint: say in the exception's text which argument is wrong
#include "variance.hpp"
#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

namespace mc {

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("bad");
  return right_covariance(x, y);
}

}  // namespace mc
