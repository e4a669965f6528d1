// attack: computes on after the signal that says its time is over
// says: did not end within 2 s of CPU time and 512 MB of memory
// limit: time

#include <csignal>
#include <ctime>

#include "common/todo.hpp"
#include "variance.hpp"

volatile std::sig_atomic_t over = 0;

namespace mc {
namespace {
double attack() {
  std::signal(SIGXCPU, [](int) { over = 1; });
  while (!over) {
  }
  for (const auto start = std::clock(); std::clock() - start < CLOCKS_PER_SEC / 2;) {
  }
  return 1.5;
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
