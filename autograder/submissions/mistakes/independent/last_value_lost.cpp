// mistake: the sum is written down before the last value is added
// caught by: 2.2 the estimate is the mean
// caught by: 2.2 the estimate is unbiased
// caught by: 2.2 the error falls
// caught by: 2.2 rare events
// hint: the last value is not in the sum
#include "independent.hpp"

#define estimate right_estimate
#include "solutions/independent.cpp"
#undef estimate

namespace mc {

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(g.dims), values;
  for (std::uint64_t i = 0; i < n; ++i) {
    for (double& coordinate : x) coordinate = to_unit(rng());
    values.push_back(g.f(x));
  }
  double sum = 0, total = 0;
  for (const double value : values) {
    total = sum;
    sum += value;
  }
  const auto size = static_cast<double>(n);
  return {total / size, std::sqrt(variance_two_pass(values) / size), n};
}

}  // namespace mc
