// mistake: makes room for one coordinate a point, however many g has
// caught by: 3.8 the estimate is the mean of the replicates
// caught by: 3.8 the error bar is the spread of the replicates
// hint: the generator fills a PointSet(n, g.dims)
#include "stratification.hpp"
#define estimate_replicated right_estimate_replicated
#include "solutions/stratification.cpp"
#undef estimate_replicated

namespace mc {

Estimate estimate_replicated(const Integrand& g, const Generator& generator, std::uint64_t n,
                             std::uint64_t replicates, Rng& rng) {
  const Generator flat = [&](PointSet& points, Rng& from) {
    PointSet line(points.size(), 1);
    generator(line, from);
    for (std::size_t d = 0; d < points.dims(); ++d) {
      std::ranges::copy(line.column(0), points.column(d).begin());
    }
  };
  return right_estimate_replicated(g, flat, n, replicates, rng);
}

}  // namespace mc
