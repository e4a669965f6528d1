// attack: answers with no sets of points at all, or with fewer than were asked for
// says: gave 0 values
#include <unistd.h>

#include "blue_noise.hpp"
#include "common/todo.hpp"
#include "runner/wire.hpp"

namespace mc {
namespace {

[[noreturn]] void answer(const wire::Writer& result) {
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  if (write(3, &header, sizeof header) < 0) _exit(1);
  if (write(3, result.bytes.data(), result.bytes.size()) < 0) _exit(1);
  _exit(0);
}

const std::vector<double> none;

}  // namespace

double toroidal_distance_squared(Point2, Point2) {
  wire::Writer result;
  result.put(none);
  answer(result);
}
void best_candidate(std::span<double>, std::span<double>, double, Rng&) {
  wire::Writer result;
  result.put(none);
  result.put(none);
  answer(result);
}
PointSet poisson_disk(double, Rng&) {
  wire::Writer result;
  result.put(none);
  result.put(none);
  result.put(std::vector<std::uint64_t>{});
  answer(result);
}
void periodogram(std::span<const double>, std::span<const double>, int, std::span<double>) {
  wire::Writer result;
  result.put(none);
  answer(result);
}
std::vector<double> radial_power(std::span<const double>, int) {
  return {};
}
PointSet tile(const PointSet&, int) {
  return PointSet(0, 2);
}

}  // namespace mc
