// mistake: divides by n where a sample variance divides by n - 1
// caught by: 1.3 the two-pass variance of tame data
// caught by: 1.3 two passes keep their digits under a large mean
// caught by: 1.3 two passes on hard cases
// hint: a sample variance divides by n - 1
#include "variance.hpp"
#define variance_two_pass right_variance_two_pass
#include "solutions/variance.cpp"
#undef variance_two_pass

namespace mc {

double variance_two_pass(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  return right_variance_two_pass(x) * ((n - 1) / n);
}

}  // namespace mc
