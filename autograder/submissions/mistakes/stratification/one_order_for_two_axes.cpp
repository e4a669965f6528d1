// mistake: axes share one order: the points lie along the diagonal
// caught by: 3.6 the permutations of the axes are independent
// caught by: 3.6 sums gain everything and products little
// hint: shuffle each of them by itself
#include "stratification.hpp"
#define latin_hypercube right_latin_hypercube
#include "solutions/stratification.cpp"
#undef latin_hypercube

namespace mc {

void latin_hypercube(PointSet& points, Rng& rng) {
  for (std::size_t d = 0; d < points.dims(); ++d) stratified_1d(points.column(d), rng);
}

}  // namespace mc
