// mistake: one large point set, cut into replicates
// caught by: 3.8 the estimate is the mean of the replicates
// caught by: 3.8 the error bar is the spread of the replicates
// caught by: 3.8 the error bar is honest for stratified points
// hint: made in one call
#include "stratification.hpp"
#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  if (n == 0 || replicates == 0) {
    return right_estimate_replicated(g, generator, n, replicates, rng);
  }
  PointSet all(n * replicates, g.dims);
  generator(all, rng);
  std::uint64_t first = 0;
  const Generator parts = [&](PointSet& points, Rng&) {
    for (std::size_t d = 0; d < g.dims; ++d) {
      std::ranges::copy(all.column(d).subspan(first, n), points.column(d).begin());
    }
    first += n;
  };
  return right_estimate_replicated(g, parts, n, replicates, rng);
}

}  // namespace mc
