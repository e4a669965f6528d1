#pragma once
// What the lecture's demo of convergence shows (./lab demo): point sets of the plane at every size,
// what they make of a few integrals, and their error over many sets. A lab's hidden case, tagged
// [.demo], writes those of its point sets.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "measurements/support/bench_data.hpp"

namespace mc::checks {

/// A function on the unit square.
struct DemoIntegrand {
  std::string name;  ///< "smooth"
  std::string formula;
  double exact;  ///< its integral
  double (*g)(double x, double y);
};

/// Five: smooth, a lamp, the shadow of a disk under that lamp, an edge, a wave.
std::span<const DemoIntegrand> demo_integrands();

/// A way of making points of the plane.
struct DemoPoints {
  std::string name;
  bool is_sequence = false;  ///< the first n of more points are the n points
  std::uint64_t most = 4096;
  /// `sets` sets of n points, by that seed.
  std::function<std::optional<PointSets>(std::uint64_t n, std::uint64_t sets, std::uint64_t seed)>
      points = {};
};

/// How many sets an RMSE is of (it is known to a part 1/sqrt(2 sets), 6 %), how many are shown.
inline constexpr std::size_t demo_sets = 128, demo_shown = 6;

/// Writes demo-`file`.json: its points at 1, 2, 4, … `most`, its estimates, its errors. Nothing
/// where the task is not written.
void write_demo(const std::string& file, const DemoPoints& points);

}  // namespace mc::checks
