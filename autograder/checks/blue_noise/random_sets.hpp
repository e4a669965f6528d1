#pragma once
// What every random set of points of lab 4 has in common: the sets differ, and so do their points.

#include <limits>
#include <string>
#include <vector>

#include "checks/blue_noise/patterns.hpp"
#include "checks/support/data.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/spectrum.hpp"

namespace mc::checks {

using domain::infinity;
using experiments::Patterns;
using experiments::Points;

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double nan = domain::not_a_number;
inline constexpr double below_one = 1 - eps / 2;

/// Of each of the lab's 30 tests that have one.
inline constexpr double alpha = 1e-8;

/// Short enough to be typed again.
inline std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;
}

inline Points uniform_points(Rng& rng, std::size_t n) {
  Points points;
  points.x = uniform_values(rng, n, 0, 1);
  points.y = uniform_values(rng, n, 0, 1);
  return points;
}

/// The distance of neighbors in the densest pattern of n points, a triangular lattice: relative
/// radii are in parts of it (Lagae and Dutre 2008, "A comparison of methods for generating Poisson
/// disk distributions").
inline double lattice_distance(double n) {
  return std::sqrt(2 / (std::sqrt(3.0) * n));
}

/// The `sets` sets of n points each, or patterns of one point at least, that were asked for. No set
/// and no part of one comes again, moved about or not, and no two points are in the same place.
SampleSets random_sets(const Measured<Points>& got, std::size_t n, std::size_t sets);
SampleSets random_sets(const Measured<Patterns>& got, double radius, std::size_t sets);

/// The sets of four measurements, so that a slow answer is within its limits.
template <class Measure>
SampleSets in_four_calls(Measure measure) {
  SampleSets all = measure();
  for (int call = 1; call < 4; ++call) all.add(measure());
  return all;
}

/// The 53 bits of coordinates after the first 16 are uniform, whatever places points prefer: fewer
/// random bits show there. At least 200 coordinates.
void require_fine(const SampleSets& sets);

/// No strip of the square is left empty. Of n independent coordinates, two neighbors are 40 / n
/// apart with probability n e^-40 < 1e-12; of points that keep a distance even more rarely.
void require_everywhere(const SampleSets& sets);

/// Every point has a disk of that radius to itself, but for rounding.
void require_apart(const SampleSets& sets, double radius);

/// The mean spectrum, up to 2 sqrt(n), of sets of about n points.
Spectrum mean_spectrum(const SampleSets& sets, double n);

/// The mean power of `sets` sets is nowhere too large for random points. The amplitude of a wave is
/// a sum of many terms that hardly depend on each other, so its power is exponential
/// (E{P^2} / E{P}^2 = 2.00 measured at the peak, for four ways of making the points), with a mean
/// of 1.9 at most: more is too regular. Their mean over sets is chi-squared with two degrees of
/// freedom per set; one of 10,000 frequencies exceeds the limit once in 10^9 runs. A lattice of n
/// points has n at some frequency, wherever it is shifted.
void expect_no_lattice(const std::string& call, const Spectrum& mean, std::size_t sets);

}  // namespace mc::checks
