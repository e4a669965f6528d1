// attack: a resolver that the loader calls before anything else
// says: made a system call

#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "common/todo.hpp"
#include "variance.hpp"

extern "C" int early() {
  return 0;
}
extern "C" void* resolve() {
  syscall(SYS_kill, -1, SIGKILL);
  return reinterpret_cast<void*>(&early);
}
extern "C" int late() __attribute__((ifunc("resolve")));

namespace mc {
namespace {
double attack() {
  return late();
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
