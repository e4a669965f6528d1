// alternative: keeps all points and values, draws dimension by dimension, and takes lab 1's two
// passes
#include "independent.hpp"

#define estimate right_estimate
#define estimate_importance right_estimate_importance
#include "solutions/independent.cpp"

#include <cmath>
#undef estimate
#undef estimate_importance

namespace mc {

Estimate of_values(const std::vector<double>& values) {
  const double error = std::sqrt(variance_two_pass(values) / static_cast<double>(values.size()));
  return {mean(values), error, values.size()};
}

Estimate estimate(const Integrand& g, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<std::vector<double>> columns(g.dims, std::vector<double>(n));
  for (auto& column : columns) {
    for (double& u : column) u = to_unit(rng());
  }
  std::vector<double> x(g.dims), values;
  for (std::uint64_t i = n; i-- > 0;) {
    for (std::size_t d = 0; d < g.dims; ++d) x[d] = columns[d][i];
    values.push_back(g.f(x));
  }
  return of_values(values);
}

Estimate estimate_importance(const Integrand& g, const Density& p, std::uint64_t n, Rng& rng) {
  require_samples(n);
  std::vector<double> x(n), weights;
  for (double& at : x) at = p.sample(to_unit(rng()));
  for (const double at : x) {
    const double inverse = 1 / p.pdf(at);  // 0 where the pdf is infinite, infinite where it is 0
    weights.push_back(std::isfinite(inverse) && inverse > 0 ? inverse * g.f({&at, 1}) : 0);
  }
  return of_values(weights);
}

}  // namespace mc
