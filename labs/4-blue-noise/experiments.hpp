#pragma once
// What lab 4 measures of a submission. Where an experiment makes several sets of points, they are
// made in turn with one generator, and returned one after the other.

#include <cstdint>
#include <vector>

#include "blue_noise.hpp"
#include "runner/wire.hpp"

namespace mc::experiments {

/// Points of the plane.
struct Points {
  std::vector<double> x, y;
};
MC_FIELDS(Points, x, y)

/// Sets of points that are not all of one size: how many each of them has.
struct Patterns {
  std::vector<double> x, y;
  std::vector<std::uint64_t> sizes;
};
MC_FIELDS(Patterns, x, y, sizes)

/// 4.1: from each point (ax[i], ay[i]) to (bx[i], by[i]).
std::vector<double> toroidal_distances_squared(std::vector<double> ax, std::vector<double> ay,
                                               std::vector<double> bx, std::vector<double> by);

/// 4.2: `sets` sets of n points; and one set, for x and y of given sizes.
Points best_candidate(std::uint64_t n, double c, std::uint64_t sets, std::uint64_t seed);
Points best_candidate_into(std::uint64_t size_x, std::uint64_t size_y, double c);

/// 4.3: `sets` sets.
Patterns poisson_disk(double radius, std::uint64_t sets, std::uint64_t seed);

/// 4.4: of each of `sets` sets of points, as many in one as in another; and of points at the
/// origin, for x, y and power of given sizes.
std::vector<double> periodogram(std::vector<double> x, std::vector<double> y, std::uint64_t sets,
                                int kmax);
std::vector<double> periodogram_into(std::uint64_t size_x, std::uint64_t size_y, int kmax,
                                     std::uint64_t size_power);

/// 4.5: of a periodogram.
std::vector<double> radial_power(std::vector<double> power, int kmax);

/// 4.6: of a pattern; and of `size` points at the origin in `dims` dimensions.
Points tile(std::vector<double> x, std::vector<double> y, int copies);
Points tile_of(std::uint64_t size, std::uint64_t dims, int copies);

/// For timing: 4.2 with c = 1 (task 2) or 4.3 (task 3), about n points, `rounds` times, round r
/// with a generator of seed `seed` + r. The last x.
double repeat(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed);

}  // namespace mc::experiments
