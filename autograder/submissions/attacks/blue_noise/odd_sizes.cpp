// attack: claims sizes of sets that do not add up to its points, nor to anything else
// earns: 6
// says: expected  whole numbers in their range
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "blue_noise.hpp"
#include "common/todo.hpp"
#include "runner/wire.hpp"

namespace mc {

double toroidal_distance_squared(Point2 a, Point2 b) {
  const double dx = std::abs(a.x - b.x), dy = std::abs(a.y - b.y);
  const double x = std::min(dx, 1 - dx), y = std::min(dy, 1 - dy);
  return x * x + y * y;
}
void best_candidate(std::span<double>, std::span<double>, double, Rng&) {
  throw todo("4.2");
}
PointSet poisson_disk(double, Rng&) {
  wire::Writer result;
  result.put(std::vector<double>{0.25, 0.5});
  result.put(std::vector<double>{0.25, 0.5});
  std::vector<std::uint64_t> sizes(40, 1);
  sizes[1] = ~std::uint64_t{0};
  result.put(sizes);
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  if (write(3, &header, sizeof header) < 0) _exit(1);
  if (write(3, result.bytes.data(), result.bytes.size()) < 0) _exit(1);
  _exit(0);
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
