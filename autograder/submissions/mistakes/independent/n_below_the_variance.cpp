// mistake: s^2 has n below it, in place of n - 1
// caught by: 2.2 the standard error
// caught by: 2.2 one sample
// hint: s^2 has n - 1 below it
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
  const auto size = static_cast<double>(n);
  const double centre = mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - centre) * (value - centre);
  return {centre, std::sqrt(squares / size / size), n};
}

}  // namespace mc
