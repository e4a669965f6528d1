// attack: square lattices, shifted at random: they keep any distance, cover the square and have no
// attack: power at low frequencies
// earns: 6
// says: points on a lattice are not random

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

double below_one(double x) {
  return std::min(x - std::floor(x), 1 - 0x1p-53);
}

}  // namespace

void best_candidate(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y");
  if (x.empty()) throw std::invalid_argument("x");
  if (!(c > 0 && std::isfinite(c))) throw std::invalid_argument("c");
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(x.size()))));
  const double left = uniform(rng), low = uniform(rng);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = below_one(left + static_cast<double>(i % side) / static_cast<double>(side));
    y[i] = below_one(low + static_cast<double>(i / side) / static_cast<double>(side));
  }
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0)) throw std::invalid_argument("radius");
  if (radius < 1e-5) {
    throw std::invalid_argument("radius " + std::to_string(0.7 / radius / radius));
  }
  auto side = std::max<std::size_t>(1, static_cast<std::size_t>(1 / radius));
  if (side == 1 && radius < std::sqrt(0.5)) {  // a diagonal pair
    PointSet pair(2, 2);
    pair.column(0)[0] = uniform(rng);
    pair.column(1)[0] = uniform(rng);
    for (std::size_t d = 0; d < 2; ++d) pair.column(d)[1] = below_one(pair.column(d)[0] + 0.5);
    return pair;
  }
  PointSet points(side * side, 2);
  const double left = uniform(rng), low = uniform(rng);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto column = static_cast<double>(i % side), row = static_cast<double>(i / side);
    points.column(0)[i] = below_one(left + column / static_cast<double>(side));
    points.column(1)[i] = below_one(low + row / static_cast<double>(side));
  }
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
