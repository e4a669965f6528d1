// mistake: begins with a radius that memory cannot hold
// caught by: 4.3 a radius too small for memory
// hint: a text that says how many points
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

PointSet poisson_disk(double radius, Rng& rng) {
  if (radius < 1e-5) throw std::invalid_argument("radius: too small");
  return right_poisson_disk(radius, rng);
}

}  // namespace mc
