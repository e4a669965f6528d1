// mistake: takes s / sqrt(n) over all points, as if they were independent
// caught by: 3.8 the error bar is the spread of the replicates
// caught by: 3.8 the error bar is honest for stratified points
// caught by: 3.8 one replicate has no error bar
// hint: as if they were independent
#include "stratification.hpp"

#include <cmath>

#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (n == 0) throw std::invalid_argument("n: there are no points");
  if (replicates == 0) throw std::invalid_argument("replicates: there are none");
  PointSet points(n, g.dims);
  std::vector<double> point(g.dims);
  Moments values;
  for (std::uint64_t replicate = 0; replicate < replicates; ++replicate) {
    generator(points, rng);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t d = 0; d < g.dims; ++d) point[d] = points.column(d)[i];
      add(values, g.f(point));
    }
  }
  return {values.mean, std::sqrt(variance(values) / static_cast<double>(values.count)),
          values.count};
}

}  // namespace mc
