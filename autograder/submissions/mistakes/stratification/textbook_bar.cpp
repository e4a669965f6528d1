// mistake: the spread of the means by E{X^2} - E{X}^2, which cancels
// caught by: 3.8 the error bar is the spread of the replicates
// hint: let lab 1 tell the variance of the means
#include "stratification.hpp"

#include <cmath>

#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  double sum = 0, squares = 0;
  const Generator watched = [&](PointSet& points, Rng& from) { generator(points, from); };
  if (n == 0 || replicates == 0) return right_estimate_replicated(g, watched, n, replicates, rng);
  for (std::uint64_t k = 0; k < replicates; ++k) {
    const double mean = right_estimate_replicated(g, watched, n, 1, rng).value;
    sum += mean, squares += mean * mean;
  }
  const auto r = static_cast<double>(replicates);
  const double variance = std::max(0.0, squares / r - sum / r * (sum / r)) * r / (r - 1);
  return {sum / r, std::sqrt(variance / r), n * replicates};
}

}  // namespace mc
