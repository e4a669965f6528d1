// attack: returns as many points as the judge will look at, all in one column
// earns: 6
// says: two points

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "blue_noise.hpp"
#include "common/todo.hpp"

namespace mc {
namespace {

double uniform(Rng& rng) {
  return static_cast<double>(rng() >> 11) * 0x1p-53;
}

}  // namespace

void best_candidate(std::span<double> x, std::span<double> y, double, Rng& rng) {
  std::fill(x.begin(), x.end(), 0.5);
  for (double& value : y) value = uniform(rng);
}

PointSet poisson_disk(double radius, Rng& rng) {
  const double most = 4 * 1.155 / (radius * radius);
  PointSet points(static_cast<std::size_t>(std::min(900000.0, most)), 2);
  for (double& x : points.column(0)) x = 0.5;
  for (double& y : points.column(1)) y = uniform(rng);
  return points;
}

double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  const double x = std::min(dx, 1 - dx), y = std::min(dy, 1 - dy);
  return x * x + y * y;
}
void periodogram(std::span<const double>, std::span<const double>, int, std::span<double>) {
  throw todo("4.4");
}
std::vector<double> radial_power(std::span<const double>, int) {
  throw todo("4.5");
}
PointSet tile(const PointSet&, int) {
  throw todo("4.6");
}

}  // namespace mc
