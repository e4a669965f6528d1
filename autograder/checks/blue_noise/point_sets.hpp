#pragma once
// Sets of points as the experiments of lab 4 send them: what each must be before it is judged, and
// what every random one has in common.

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "checks/blue_noise/patterns.hpp"
#include "checks/support/data.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/spectrum.hpp"

namespace mc::checks {

using experiments::Patterns;
using experiments::Points;
using Values = std::vector<double>;

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double below_one = 1 - eps / 2;

/// Of each of the lab's 30 tests that have one.
inline constexpr double alpha = 1e-8;

/// The distance of neighbours in the densest pattern of n points, a triangular lattice: relative
/// radii are in parts of it (Lagae and Dutre 2008, "A comparison of methods for generating Poisson
/// disk distributions").
inline double lattice_distance(double n) {
  return std::sqrt(2 / (std::sqrt(3.0) * n));
}

inline std::uint64_t fresh_seed(Rng& rng) {
  return rng() >> 32;  // short enough to be typed again
}

inline Points uniform_points(Rng& rng, std::size_t n) {
  Points points;
  points.x = uniform_values(rng, n, 0, 1);
  points.y = uniform_values(rng, n, 0, 1);
  return points;
}

// Sets of points, which stay in `got`: no set is another one moved about, and no two points are in
// the same place.

/// The `sets` sets of n points each that were asked for.
std::vector<Set> sets_of(const Measured<Points>& got, std::size_t n, std::size_t sets);

/// The `sets` Poisson-disk patterns that were asked for, each of one point at least.
std::vector<Set> sets_of(const Measured<Patterns>& got, double radius, std::size_t sets);

/// What follows the first 16 bits of all coordinates is uniform, whatever places points prefer:
/// fewer bits show there. At least 200 coordinates.
void require_fine(const std::string& call, std::span<const Set> sets);

/// The mean spectrum up to 2 sqrt(n) of sets of about n points.
Spectrum mean_spectrum(std::span<const Set> sets, double n);

/// The mean power of `sets` sets is nowhere too large for random points. The amplitude of a wave is
/// a sum of many terms that hardly depend on each other, so its power is exponential
/// (E{P^2} / E{P}^2 = 2.00 measured at the peak, for four ways of making the points), with a mean
/// of 1.9 at most: more is too regular. Their mean over sets is chi-squared with two degrees of
/// freedom a set; the limit is passed by one of 10,000 frequencies once in 10^9 runs. A lattice of
/// n points has n at some frequency, wherever it is shifted.
void expect_no_lattice(const std::string& call, const Spectrum& mean, std::size_t sets);

}  // namespace mc::checks
