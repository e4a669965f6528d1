// mistake: axis 3 comes in the order of axis 0, axis 4 in that of 1, …
// caught by: 3.6 the permutations of the axes are independent
// hint: shuffle each of them by itself
#include "stratification.hpp"
#define latin_hypercube right_latin_hypercube
#include "solutions/stratification.cpp"
#undef latin_hypercube

namespace mc {

void latin_hypercube(PointSet& points, Rng& rng) {
  const Rng start(rng());
  for (std::size_t d = 0; d < points.dims(); ++d) {
    stratified_1d(points.column(d), rng);
    Rng order = start;
    for (std::size_t k = 0; k < d % 3; ++k) order = Rng(order());
    shuffle(points.column(d), order);
  }
}

}  // namespace mc
