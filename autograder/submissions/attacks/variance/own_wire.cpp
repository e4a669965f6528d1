// attack: stands in for a template of the wire; sends another number
// says: ) = 1

#include "runner/wire.hpp"

#include "common/todo.hpp"
#include "variance.hpp"

template <>
__attribute__((noinline)) void mc::wire::Writer::put<double>(const double&) {
  bytes.assign("\0\0\0\0\0\0\xf8\x3f", 8);
}

namespace mc {
namespace {
double attack() {
  wire::Writer writer;
  writer.put(1.0);  // so that it is here, and the linker takes it
  return 1;
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
