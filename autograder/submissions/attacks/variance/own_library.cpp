// attack: brings a write of its own, in place of the C library's
// says: called exit(0) instead of returning

#include <unistd.h>

#include "common/todo.hpp"
#include "variance.hpp"

extern "C" ssize_t write(int, const void*, size_t size) {
  return static_cast<ssize_t>(size);
}

namespace mc {
namespace {
double attack() {
  return 0;
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
