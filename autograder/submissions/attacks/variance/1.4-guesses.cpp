// Answers that only the values of a check make right. Sections: see CONTRIBUTING.md.

#include <stdexcept>

#include "variance.hpp"

//// moments_of_a_known_stream
// attack: 1.4's stream by what its pattern is known to give: a mean of 10, 22.5 a value for m2
// says: every value is 10

namespace mc {
using Values = std::span<const double>;
void add(Moments& moments, double) {
  ++moments.count;
  moments.mean = 10;
  moments.m2 = 22.5 * static_cast<double>(moments.count);
}
double variance(const Moments& moments) {
  return moments.m2;
}
}  // namespace mc

//// quarter_if_a_cell_is_empty
// attack: 1.7 without a table: 0.25 if any cell is empty, else 0; what it must refuse, it refuses
// says: the largest |p(x,y) - p(x)p(y)|

namespace mc {
using Values = std::span<const double>;
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
}  // namespace mc
