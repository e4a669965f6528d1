// Lab 4 · blue noise. labs/4-blue-noise/blue_noise.hpp states what each function promises, and
// labs/4-blue-noise/README.md is the handout. Write the tasks in any order and check them with
//
//   ./lab check blue_noise              the whole lab
//   ./lab check blue_noise --only 4.1   one task

#include "blue_noise.hpp"

#include <cmath>

#include "common/todo.hpp"

namespace mc {

/// An example of style, not a task: p, moved by (dx, dy) on the torus.
[[maybe_unused]] static Point2 moved(Point2 p, double dx, double dy) {
  const auto wrapped = [](double t) {
    t -= std::floor(t);
    return t < 1 ? t : 0;  // -1e-20 + 1 rounds to 1, which is 0 on the torus
  };
  return {wrapped(p.x + dx), wrapped(p.y + dy)};
}

double toroidal_distance_squared(Point2 a, Point2 b) {
  throw todo("4.1");  // TODO(4.1): along each axis, the shorter of the two paths
}

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  throw todo("4.2");  // TODO(4.2): of ceil(c i) + 1 candidates, keep the farthest one
}

PointSet poisson_disk(double radius, Rng& rng) {
  throw todo("4.3");  // TODO(4.3): no two closer than radius, nearly maximal
}

void periodogram(std::span<const double> x, std::span<const double> y, int kmax,
                 std::span<double> power) {
  throw todo("4.4");  // TODO(4.4): the squared absolute value of a sum of waves, over N
}

std::vector<double> radial_power(std::span<const double> power, int kmax) {
  throw todo("4.5");  // TODO(4.5): the mean over each ring of frequencies; NaN for ring 0
}

PointSet tile(const PointSet& pattern, int copies) {
  throw todo("4.6");  // TODO(4.6): copies side by side; every coordinate below 1
}

// TODO(4.7): the speed task adds no function: when 4.2 and 4.3 are correct, lay a grid over the
// square, so that each search visits nearby points only.

}  // namespace mc
