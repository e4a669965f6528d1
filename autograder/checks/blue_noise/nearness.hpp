#pragma once
// How a best candidate is recognized: by how lonely it is, in terms of probability.

#include <functional>
#include <string>
#include <vector>

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/battery.hpp"

namespace mc::checks {

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
