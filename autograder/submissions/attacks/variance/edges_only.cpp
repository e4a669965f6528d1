// attack: does nothing but the edges: NaN for lists of fewer than two, empty parts, refusals, and
// what is not finite
// says: = 0

#include <cmath>
#include <limits>
#include <stdexcept>

#include "variance.hpp"

namespace mc {
using Values = std::span<const double>;
namespace {
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
bool all_finite(Values x) {
  for (double value : x) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}
}  // namespace
double mean(Values x) {
  return x.empty() || !all_finite(x) ? nan : 0;
}
double variance_textbook(Values x) {
  return x.size() < 2 || !all_finite(x) ? nan : 0;
}
double variance_two_pass(Values x) {
  return x.size() < 2 || !all_finite(x) ? nan : 0;
}
void add(Moments& moments, double) {
  ++moments.count;
}
double variance(const Moments& moments) {
  return moments.count < 2 ? nan : 0;
}
Moments merge(const Moments& a, const Moments& b) {
  return a.count == 0 ? b : a;
}
double covariance(Values x, Values y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y");
  return x.size() < 2 || !all_finite(x) || !all_finite(y) ? nan : 0;
}
double dependence(Values joint, std::size_t columns) {
  double total = 0;
  for (double weight : joint) total += weight < 0 ? nan : weight;
  if (columns == 0 || joint.size() % columns != 0 || !(total > 0) || !std::isfinite(total)) {
    throw std::invalid_argument("joint, columns, total, weight");
  }
  return 0;
}
Moments moments(Values x) {
  return {x.size(), 0, all_finite(x) ? 0 : nan};
}
}  // namespace mc
