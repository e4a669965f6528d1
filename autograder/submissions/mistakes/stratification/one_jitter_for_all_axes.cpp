// mistake: shuffles the same jittered column for every axis
// caught by: 3.6 the permutations of the axes are independent
// caught by: 3.6 sums gain everything and products little
// hint: have their exact variance
#include "stratification.hpp"
#define latin_hypercube right_latin_hypercube
#include "solutions/stratification.cpp"
#undef latin_hypercube

namespace mc {

void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) {
    if (d == 0) {
      stratified_1d(points.column(0), rng);
    } else {
      std::ranges::copy(points.column(0), points.column(d).begin());
    }
  }
  for (std::size_t d = 0; d < points.dims(); ++d) shuffle(points.column(d), rng);
}

}  // namespace mc
