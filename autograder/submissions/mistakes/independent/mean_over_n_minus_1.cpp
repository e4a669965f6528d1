// mistake: the mean, too, is over n - 1
// caught by: 2.2 the estimate is the mean
// caught by: 2.2 the estimate is unbiased
// caught by: 2.2 the error falls
// caught by: 2.2 rare events
// hint: this divides by n - 1; only a variance does
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
  double sum = 0;
  for (const double value : values) sum += value;
  const auto size = static_cast<double>(n);
  return {sum / (size - 1), std::sqrt(variance_two_pass(values) / size), n};
}

}  // namespace mc
