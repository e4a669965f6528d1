// mistake: adds up what all cells miss independence by
// caught by: 1.7 the dependence of a joint table
// caught by: 1.7 independent variables
// caught by: 1.7 the circle
// hint: this is the sum of all cells' differences
#include "variance.hpp"
#define dependence right_dependence
#include "solutions/variance.cpp"
#undef dependence

namespace mc {

double dependence(std::span<const double> joint, std::size_t columns) {
  right_dependence(joint, columns);  // for what it throws
  double total = 0, sum = 0;
  for (double weight : joint) total += weight;
  std::vector<double> p_x(joint.size() / columns), p_y(columns);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    p_x[i / columns] += joint[i] / total;
    p_y[i % columns] += joint[i] / total;
  }
  for (std::size_t i = 0; i < joint.size(); ++i) {
    sum += std::abs(joint[i] / total - p_x[i / columns] * p_y[i % columns]);
  }
  return sum;
}

}  // namespace mc
