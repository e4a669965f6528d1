// attack: one random point is every pattern
// earns: 6
// says: there is room for about 0.7 / radius^2 points

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
  if (x.size() != y.size() || x.empty()) throw std::invalid_argument("x, y");
  std::fill(x.begin(), x.end(), uniform(rng));
  std::fill(y.begin(), y.end(), uniform(rng));
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 1e-5)) throw std::invalid_argument("radius");
  PointSet point(1, 2);
  point.column(0)[0] = uniform(rng);
  point.column(1)[0] = uniform(rng);
  return point;
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
