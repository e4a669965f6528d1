// mistake: takes as many pairs as there are where the sizes differ
// caught by: 1.6 lists of two sizes
// caught by: 1.6 the refusal names
// hint: misuse throws std::invalid_argument
#include "variance.hpp"
#define covariance right_covariance
#include "solutions/variance.cpp"
#undef covariance

namespace mc {

double covariance(std::span<const double> x, std::span<const double> y) {
  const std::size_t pairs = std::min(x.size(), y.size());
  return right_covariance(x.first(pairs), y.first(pairs));
}

}  // namespace mc
