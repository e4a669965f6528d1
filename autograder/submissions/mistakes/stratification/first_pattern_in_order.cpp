// mistake: shuffles all patterns but the first, so the first n of N see its first rows
// caught by: 3.4 long patterns have no trend
// caught by: 3.4 the first n of N are a fair sample
// hint: who stops early
#include "stratification.hpp"
#define stratified right_stratified
#include "solutions/stratification.cpp"
#undef stratified

namespace mc {

void stratified(PointSet& points, Rng& rng) {
  if (points.dims() < 2) return stratified_1d(points.column(0), rng);
  PointSet rest(points.size(), points.dims() - 2);
  right_stratified(rest, rng);
  stratified_2d(points.column(0), points.column(1), strata(points.size()), rng);
  for (std::size_t d = 2; d < points.dims(); ++d) {
    std::ranges::copy(rest.column(d - 2), points.column(d).begin());
  }
}

}  // namespace mc
