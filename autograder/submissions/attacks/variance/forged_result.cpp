// attack: writes a result of its own and leaves; it is a number like any other
// says: ) = 1.5

#include <unistd.h>

#include "runner/wire.hpp"

#include "common/todo.hpp"
#include "variance.hpp"

namespace mc {
namespace {
double attack() {
  wire::Writer result;
  result.put(1.5);
  const wire::Header header{wire::magic, wire::Status::value, 0, result.bytes.size()};
  write(3, &header, sizeof header);
  write(3, result.bytes.data(), result.bytes.size());
  _exit(0);
}
}  // namespace

using Values = std::span<const double>;
double mean(Values) {
  return attack();
}
double variance_textbook(Values) {
  throw todo("1.2");
}
double variance_two_pass(Values) {
  throw todo("1.3");
}
void add(Moments&, double) {
  throw todo("1.4");
}
double variance(const Moments&) {
  throw todo("1.4");
}
Moments merge(const Moments&, const Moments&) {
  throw todo("1.5");
}
double covariance(Values, Values) {
  throw todo("1.6");
}
double dependence(Values, std::size_t) {
  throw todo("1.7");
}
Moments moments(Values) {
  throw todo("1.8");
}
}  // namespace mc
