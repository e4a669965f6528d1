// mistake: leaves the gaps that 30 tries around each point miss
// fails: 4.3
// hint: gaps are left
#include "autograder/submissions/mistakes/blue_noise/4.3.cpp"

namespace mc {

/// Bridson 2007: new points around old ones, between one and two radii away.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius >= least_radius)) return right_poisson_disk(radius, rng);
  Bridson pattern{radius, rng};
  pattern.fill(30, [&] { return radius * std::sqrt(1 + 3 * uniform(rng)); });
  return columns_of(pattern.points);
}

}  // namespace mc
