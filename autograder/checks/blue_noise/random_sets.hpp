#pragma once
// Random point sets of lab 4, for checks, plots and benchmark, and their common properties.

#include "4-blue-noise/experiments.hpp"
#include "checks/support/checks.hpp"
#include "checks/support/spectrum.hpp"

namespace mc::checks {

/// The radius for about n points: a Poisson-disk pattern has about 0.7 / radius^2 (0.696 in 400).
inline double radius_for(double n) {
  return std::sqrt(0.7 / n);
}

/// The lists x, y and sizes of `sets` patterns. At most 1.155 / radius^2 points fit; four times as
/// many are accepted here, so that a later test can see that the radius was halved.
inline std::vector<ListSpec> patterns_spec(double radius, std::size_t sets) {
  const double most = std::ceil(4 * 1.155 / (radius * radius) + 4);
  const std::size_t points = static_cast<std::size_t>(most) * sets;
  return {{points, unit, true}, {points, unit, true}, {sets, up_to(most)}};
}

/// The patterns; none if the sizes do not add up.
inline SampleSets patterns_in(const std::string& call, const experiments::Patterns& all) {
  const auto sum = std::accumulate(all.sizes.begin(), all.sizes.end(), std::uint64_t{0});
  if (sum != all.x.size()) return {call, {}, 2, {}};
  return sets_from_xy(call, all.x, all.y, all.sizes);
}

using experiments::Patterns;
using experiments::Points;

inline constexpr double below_one = 1 - eps / 2;

inline Points uniform_points(Rng& rng, std::size_t n) {
  Points points;
  points.x = uniform_values(rng, n, 0, 1);
  points.y = uniform_values(rng, n, 0, 1);
  return points;
}

/// The distance of neighbors in the densest pattern of n points, a triangular lattice. Relative
/// radii are fractions of it (Lagae and Dutre 2008, "A comparison of methods for generating Poisson
/// disk distributions").
inline double lattice_distance(double n) {
  return std::sqrt(2 / (std::sqrt(3.0) * n));
}

/// The requested sets of n points each, or patterns with at least one point each. No neighborhood
/// and no point occurs twice; in a pattern no two points are closer than the radius.
SampleSets random_sets(const Measured<Points>& got, std::size_t n, std::size_t sets);
SampleSets random_sets(const Measured<Patterns>& got, double radius, std::size_t sets);

/// The sets of four measurements, so that a slow answer stays within its limits.
template <class Measure>
SampleSets in_four_calls(Measure measure) {
  SampleSets all = measure();
  for (int call = 1; call < 4; ++call) all.add(measure());
  return all;
}

/// The bits of at least 200 coordinates from the 17th on are uniform, which does not depend on
/// where points lie: detects coordinates with too few random bits.
void require_fine(const SampleSets& sets);

/// No strip of the square is empty. Two neighbors of n independent coordinates are 40 / n apart
/// with probability n e^-40 < 1e-12; points that keep a distance, even more rarely.
void require_everywhere(const SampleSets& sets);

/// The mean spectrum, up to 2 sqrt(n), of sets of about n points.
Spectrum mean_spectrum(const SampleSets& sets, double n);

/// The mean power of `sets` sets is nowhere too large for random points. The amplitude of a wave is
/// a sum of many nearly independent terms, so its power is exponential (E{P^2} / E{P}^2 = 2.00 at
/// the peak, measured for four algorithms), with a mean of at most 1.9: more is too regular. The
/// mean over sets is chi-squared with two degrees of freedom per set; one of 10,000 frequencies
/// exceeds the limit once in 10^9 runs. A lattice of n points has a power of n.
void expect_no_lattice(const std::string& call, const Spectrum& mean, std::size_t sets);

/// 4.2: `count` random points of a set, of indices first to last - 1, are the best of ceil(c i) + 1
/// candidates. They are chosen now, so the submission could not know them. Half the required
/// candidates are missed in 350 points only once in 1,000 runs.
void judge_points(const SampleSets& set, double c, std::size_t first, std::size_t last,
                  std::size_t count, Rng& rng);

}  // namespace mc::checks
