// mistake: draws a random stratum for every point and axis
// caught by: 3.6 every axis is stratified
// caught by: 3.6 the permutations of the axes are independent
// caught by: 3.6 sums gain everything and products little
// hint: each column is a pattern of 3.1
#include "stratification.hpp"
#define latin_hypercube right_latin_hypercube
#include "solutions/stratification.cpp"
#undef latin_hypercube

namespace mc {

void latin_hypercube(PointSet& points, Rng& rng) {
  const Strata strata(points.size());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    for (double& x : points.column(d)) {
      x = strata.place(static_cast<double>(rng() % points.size()), to_unit(rng()));
    }
  }
}

}  // namespace mc
