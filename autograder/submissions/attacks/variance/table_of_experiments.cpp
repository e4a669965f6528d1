// attack: makes the table of experiments writable and puts one of its own into it
// says: ) = 1.5

#include <sys/mman.h>

#include "runner/experiment.hpp"

#include "common/todo.hpp"
#include "variance.hpp"

std::string forged(mc::wire::Reader&) {
  return std::string("\0\0\0\0\0\0\xf8\x3f", 8);
}
const bool done = [] {
  const auto all = mc::runner::experiments();
  const auto page = reinterpret_cast<std::uintptr_t>(all.data()) & ~std::uintptr_t{4095};
  mprotect(reinterpret_cast<void*>(page), 8192, PROT_READ | PROT_WRITE);
  const_cast<mc::runner::Experiment&>(all[0]).from_wire = forged;
  return true;
}();

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
