// mistake: pads 1D patterns, two of them where a 2D pattern is due
// caught by: 3.4 every pair of dimensions is a jittered grid
// caught by: 3.4 patterns are shuffled independently
// caught by: 3.4 long patterns have no trend
// caught by: 3.4 the first n of N are a fair sample
// hint: two 1D patterns are not a 2D pattern
#include "stratification.hpp"
#define stratified right_stratified
#include "solutions/stratification.cpp"
#undef stratified

namespace mc {

void stratified(PointSet& points, Rng& rng) {
  latin_hypercube(points, rng);
}

}  // namespace mc
