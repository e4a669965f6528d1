#pragma once
// The experiments of lab 4: what is run and measured in a submission. An experiment that makes
// several sets of points makes them with one generator and returns them one after another.

#include <cstdint>
#include <vector>

#include "blue_noise.hpp"
#include "runner/wire.hpp"

namespace mc::experiments {

/// Points in the plane.
struct Points {
  std::vector<double> x, y;
};
MC_FIELDS(Points, x, y)

/// Sets of points of different sizes, one after another, and the number of points in each set.
struct Patterns {
  std::vector<double> x, y;
  std::vector<std::uint64_t> sizes;
};
MC_FIELDS(Patterns, x, y, sizes)

/// 4.1: the squared distance from each point (ax[i], ay[i]) to (bx[i], by[i]).
std::vector<double> toroidal_distances_squared(std::vector<double> ax, std::vector<double> ay,
                                               std::vector<double> bx, std::vector<double> by);

/// 4.2: `sets` sets of n points; and one set, written to an x and a y of the given sizes.
Points best_candidate(std::uint64_t n, double c, std::uint64_t sets, std::uint64_t seed);
Points best_candidate_into(std::uint64_t size_x, std::uint64_t size_y, double c);

/// 4.3: `sets` patterns.
Patterns poisson_disk(double radius, std::uint64_t sets, std::uint64_t seed);

/// 4.4: the periodograms of `sets` sets of points of equal size; and one call with an x, a y and a
/// power of the given sizes, all points at the origin.
std::vector<double> periodogram(std::vector<double> x, std::vector<double> y, std::uint64_t sets,
                                int kmax);
std::vector<double> periodogram_into(std::uint64_t size_x, std::uint64_t size_y, int kmax,
                                     std::uint64_t size_power);

/// 4.5: the radial power of a periodogram.
std::vector<double> radial_power(std::vector<double> power, int kmax);

/// 4.6: the tiling of a pattern; and of `size` points at the origin in `dims` dimensions.
Points tile(std::vector<double> x, std::vector<double> y, int copies);
Points tile_of(std::uint64_t size, std::uint64_t dims, int copies);

/// For timing: makes about n points `rounds` times, by 4.2 with c = 1 (task 2) or by 4.3 (task 3).
/// Round r uses a generator with the seed `seed` + r. Returns the last x.
double repeat(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed);

/// The same by plain loops over all points, which 4.7 is compared with: every candidate by its
/// distances to all points; darts until 10,000 in a row miss.
double repeat_plain(unsigned task, std::uint64_t n, std::uint64_t rounds, std::uint64_t seed);

}  // namespace mc::experiments
