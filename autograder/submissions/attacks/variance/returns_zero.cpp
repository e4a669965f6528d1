// attack: returns 0 whatever is asked, which is what several checks expect of something
// earns: 0
// says: = 0

#include "variance.hpp"

namespace mc {
using Values = std::span<const double>;
double mean(Values) {
  return 0;
}
double variance_textbook(Values) {
  return 0;
}
double variance_two_pass(Values) {
  return 0;
}
void add(Moments&, double) {}
double variance(const Moments&) {
  return 0;
}
Moments merge(const Moments&, const Moments&) {
  return {};
}
double covariance(Values, Values) {
  return 0;
}
double dependence(Values, std::size_t) {
  return 0;
}
Moments moments(Values) {
  return {};
}
}  // namespace mc
