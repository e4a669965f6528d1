// attack: looks like link-time optimisation, for which a linker starts a compiler of its own
// says: mean({
// never says: linker

#include "common/todo.hpp"
#include "variance.hpp"

asm(".section .gnu.lto_.symtab.1, \"e\"\n.zero 64\n"
    ".section .gnu.lto_.opts, \"e\"\n.asciz \"'-fplugin=/etc/passwd'\"\n"
    ".section .gnu.lto_main.1, \"e\"\n.zero 64\n.previous");

namespace mc {
namespace {
double attack() {
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
