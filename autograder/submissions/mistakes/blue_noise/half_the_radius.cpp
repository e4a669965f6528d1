// mistake: keeps points apart by the radius of discs that may touch
// caught by: 4.3 no two points are closer
// caught by: 4.3 a radius too large
// caught by: 4.3 Poisson disks are blue
// hint: half the radius is kept
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

PointSet poisson_disk(double radius, Rng& rng) {
  return right_poisson_disk(radius >= 2e-5 ? radius / 2 : radius, rng);
}

}  // namespace mc
