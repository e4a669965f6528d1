// mistake: draws one 2D pattern and shuffles it anew for each pair of dimensions
// caught by: 3.4 patterns are shuffled independently
// hint: draw each afresh
#include "stratification.hpp"
#define stratified right_stratified
#include "solutions/stratification.cpp"
#undef stratified

namespace mc {

void stratified(PointSet& points, Rng& rng) {
  right_stratified(points, rng);
  std::vector<double> x(points.size()), y(points.size());
  if (points.dims() < 4) return;
  std::ranges::copy(points.column(0), x.begin());
  std::ranges::copy(points.column(1), y.begin());
  for (std::size_t d = 2; d + 1 < points.dims(); d += 2) {
    Rng again = rng;
    shuffle(x, rng);
    shuffle(y, again);
    std::ranges::copy(x, points.column(d).begin());
    std::ranges::copy(y, points.column(d + 1).begin());
  }
}

}  // namespace mc
