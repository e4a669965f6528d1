#pragma once
// How a best candidate is known: by how lonely it is, in terms of probability.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "checks/blue_noise/point_sets.hpp"

namespace mc::checks {

/// The fraction of the square that is nearer to one of the points before point i than point i is.
struct Nearness {
  std::size_t i = 0;
  double part = 0;
};

/// Of point i of a set, computed along `rows` lines that begin at a place drawn from `rng`.
Nearness nearness(const Set& set, std::size_t i, std::size_t rows, Rng& rng);

/// Uniform candidates have a nearness that is uniform; the largest of m of them, raised to the m-th
/// power, is uniform again. So this is uniform in [0, 1) for every right way, and independent from
/// point to point, if there were `candidates(i)` of them.
Values by_candidates(std::span<const Nearness> all,
                     const std::function<double(double)>& candidates);

/// Judges that ceil(c i) + 1 candidates were there for each of these points.
void expect_candidates(const std::string& call, std::span<const Nearness> all, double c,
                       const std::string& likely);

/// Are these points the best of so many candidates? One in 10,000 right answers is missed.
bool have_candidates(std::span<const Nearness> all,
                     const std::function<double(double)>& candidates);

/// Which well-known mistake explains points 1, 2, … of these sets, point by point, if one does and
/// no other. Of thousands of sets: some mistakes are alike.
std::string candidates_hint(std::span<const Set> sets, double c);

}  // namespace mc::checks
