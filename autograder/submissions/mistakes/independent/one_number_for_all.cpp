// mistake: one random number serves every coordinate of a point: all lie on the diagonal
// caught by: 2.2 the points are uniform
// caught by: 2.2 the estimate is unbiased
// caught by: 2.2 rare events
// hint: one number for both fills a line
// hint: that is the mean of x^2: one number for both x and y
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims);
  Moments values;
  for (std::uint64_t i = 0; i < n; ++i) {
    std::fill(x.begin(), x.end(), to_unit(rng()));
    add(values, g.f(x));
  }
  return mean_of(values);
}

}  // namespace mc
