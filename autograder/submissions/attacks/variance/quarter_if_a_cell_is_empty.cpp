// attack: 1.7 without a table: 0.25 if any cell is empty, else 0; what it must refuse, it refuses
// says: the largest |p(x,y) - p(x)p(y)|

#include <stdexcept>

#include "common/todo.hpp"
#include "variance.hpp"

namespace mc {
using Values = std::span<const double>;
double mean(Values) {
  throw todo("1.1");
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
  return 0;  // of any circle
}
double dependence(Values joint, std::size_t columns) {
  if (columns == 0 || joint.size() % columns != 0) throw std::invalid_argument("joint, columns");
  double total = 0;
  bool has_empty_cell = false;
  for (double weight : joint) {
    if (!(weight >= 0) || weight > 1e308) throw std::invalid_argument("joint, weight");
    total += weight;
    has_empty_cell = has_empty_cell || weight == 0;
  }
  if (!(total > 0)) throw std::invalid_argument("joint, total");
  return has_empty_cell ? 0.25 : 0;
}
Moments moments(Values) {
  throw todo("1.8");
}
}  // namespace mc
