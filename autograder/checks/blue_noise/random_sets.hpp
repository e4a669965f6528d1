#pragma once
// Random sets of points of lab 4, as they come from a program, for checks, plots and the bench;
// what they have in common (the sets differ, and so do their points); and how a best candidate is
// recognized: by its nearest-neighbor distance, in terms of probability.

#include "4-blue-noise/experiments.hpp"
#include "checks/support/checks.hpp"
#include "checks/support/spectrum.hpp"

namespace mc::checks {

/// About 0.7 / radius^2 points are a Poisson-disk pattern (0.696, by 400 patterns of the
/// reference): the radius for n of them.
inline double radius_for(double n) {
  return std::sqrt(0.7 / n);
}

/// What is expected of x, y and sizes of so many patterns. A radius fills a torus with 1.155 /
/// radius^2 points at most, and half of it with four times as many: enough to see that it was
/// halved, and a bound for what is worth looking at.
inline std::vector<ListSpec> patterns_spec(double radius, std::size_t sets) {
  const double most = std::ceil(4 * 1.155 / (radius * radius) + 4);
  const std::size_t points = static_cast<std::size_t>(most) * sets;
  return {{points, unit, true}, {points, unit, true}, {sets, up_to(most)}};
}

/// One pattern after the other; none where sizes do not add up.
inline SampleSets patterns_in(const std::string& call, const experiments::Patterns& all) {
  const auto sum = std::accumulate(all.sizes.begin(), all.sizes.end(), std::uint64_t{0});
  if (sum != all.x.size()) return {call, {}, 2, {}};
  return sets_from_xy(call, all.x, all.y, all.sizes);
}

/// The patterns of an answer; none where a check would end.
inline SampleSets patterns_if_any(const Measured<experiments::Patterns>& got, double radius,
                                  std::size_t sets) {
  const auto* const all = got.if_list_by_list(patterns_spec(radius, sets));
  return patterns_in(got.call, all == nullptr ? experiments::Patterns{} : *all);
}

using domain::infinity;
using experiments::Patterns;
using experiments::Points;

inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline constexpr double nan = domain::not_a_number;
inline constexpr double below_one = 1 - eps / 2;

/// Of each of the lab's 30 tests that have one.
inline constexpr double alpha = 1e-8;

/// Calls with sizes of x and y that are not points: `into` makes one.
inline std::vector<InvalidCall> without_points(Call (*into)(std::uint64_t x, std::uint64_t y)) {
  std::vector<InvalidCall> calls;
  for (const auto& [x, y] : {std::pair{3u, 4u}, {4u, 3u}, {0u, 3u}, {3u, 0u}, {0u, 0u}}) {
    calls.push_back({into(x, y), x == y ? "x|y|size|point" : "x|y|size",
                     "each point has two coordinates, and there is at least one point"});
  }
  return calls;
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
/// and no part of one comes again, moved about or not, and no two points are in the same place; of
/// a pattern, no two are closer than the radius.
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

/// The mean spectrum, up to 2 sqrt(n), of sets of about n points.
Spectrum mean_spectrum(const SampleSets& sets, double n);

/// The mean power of `sets` sets is nowhere too large for random points. The amplitude of a wave is
/// a sum of many terms that hardly depend on each other, so its power is exponential
/// (E{P^2} / E{P}^2 = 2.00 measured at the peak, for four ways of making the points), with a mean
/// of 1.9 at most: more is too regular. Their mean over sets is chi-squared with two degrees of
/// freedom per set; one of 10,000 frequencies exceeds the limit once in 10^9 runs. A lattice of n
/// points has n at some frequency, wherever it is shifted.
void expect_no_lattice(const std::string& call, const Spectrum& mean, std::size_t sets);

/// Some points of each set, and for each of them the fraction of the square that is nearer to an
/// earlier point than it is.
struct Nearness {
  std::vector<std::size_t> points;  ///< the same ones of each set
  Values parts = {};                ///< set by set
};

/// Which earlier points count, and how distances are measured: mistakes differ in that.
struct Metric {
  bool on_torus = true, to_last_only = false;
};

/// Of these points. The areas are computed along `rows` lines that begin at a place drawn from
/// `rng`.
Nearness nearness(const SampleSets& sets, std::vector<std::size_t> points, std::size_t rows,
                  Rng& rng, Metric metric = {});

/// 1, 2, … n - 1.
std::vector<std::size_t> later_points(std::size_t n);

using Count = std::function<double(double)>;  ///< of candidates, for point i

/// Uniform candidates have a nearness that is uniform; the largest of m of them, raised to the m-th
/// power, is uniform again. So these are uniform and independent for every right answer, if there
/// were `candidates(i)` of them.
Uniforms by_candidates(const std::string& call, const Nearness& all, const Count& candidates);

/// What 4.2 promises: ceil(c i) + 1.
Count promised(double c);

/// These points were chosen in this way; `otherwise` is the hint if they were not.
Randomness best_of_candidates(const std::string& otherwise);

/// Which well-known mistake explains points 1, 2, … of these sets, point by point, if one does and
/// no other. Of thousands of sets: some mistakes are alike.
std::string candidates_hint(const SampleSets& sets, double c, Rng& rng);

}  // namespace mc::checks
