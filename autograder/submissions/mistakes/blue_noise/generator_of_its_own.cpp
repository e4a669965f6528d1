// mistake: draws from a copy of the generator, so every pattern is the same one
// caught by: 4.3 no two points are closer
// caught by: 4.3 the pattern is nearly maximal
// caught by: 4.3 Poisson disks are blue
// caught by: 4.3 a radius too large
// hint: draw from the generator that is handed in
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

PointSet poisson_disk(double radius, Rng& rng) {
  Rng copy = rng;
  return right_poisson_disk(radius, copy);
}

}  // namespace mc
