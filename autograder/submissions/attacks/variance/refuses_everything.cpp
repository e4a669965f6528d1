// attack: throws std::invalid_argument whatever is asked, and names every argument: refusals are
// right
// says: these arguments are valid

#include <stdexcept>

#include "common/todo.hpp"
#include "variance.hpp"

namespace mc {
using Values = std::span<const double>;
double mean(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
double variance_textbook(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
double variance_two_pass(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
void add(Moments&, double) {
  throw std::invalid_argument("x y joint columns total weight");
}
double variance(const Moments&) {
  throw std::invalid_argument("x y joint columns total weight");
}
Moments merge(const Moments&, const Moments&) {
  throw std::invalid_argument("x y joint columns total weight");
}
double covariance(Values, Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
double dependence(Values, std::size_t) {
  throw std::invalid_argument("x y joint columns total weight");
}
Moments moments(Values) {
  throw std::invalid_argument("x y joint columns total weight");
}
}  // namespace mc
