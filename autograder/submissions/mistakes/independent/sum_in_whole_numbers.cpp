// mistake: adds the values up with std::accumulate(..., 0), in int
// caught by: 2.2 the estimate is the mean
// caught by: 2.2 the estimate is unbiased
// caught by: 2.2 the error falls
// caught by: 2.2 rare events
// hint: added up in an int
#include "independent.hpp"

#include <numeric>

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
  const auto size = static_cast<double>(n);
  const int sum = std::accumulate(values.begin(), values.end(), 0);
  return {sum / size, std::sqrt(variance_two_pass(values) / size), n};
}

}  // namespace mc
