// attack: calls the kernel as a 32-bit program does, where 5 means open and not fstat
// says: mean(

#include <sys/syscall.h>
#include <unistd.h>

#include "common/todo.hpp"
#include "variance.hpp"

namespace mc {
namespace {
double attack() {
#ifdef __x86_64__
  long result = 5;
  asm volatile("int $0x80" : "+a"(result) : "b"("/etc/passwd"), "c"(0) : "memory");
  return static_cast<double>(result);
#else
  return static_cast<double>(syscall(SYS_openat, -100, "/etc/passwd", 0));
#endif
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
