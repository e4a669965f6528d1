// mistake: takes the weights for probabilities
// caught by: 1.7 the dependence of a joint table
// caught by: 1.7 independent variables have dependence zero
// caught by: 1.7 the circle
// hint: the weights are no probabilities yet: divide by their total
#include "variance.hpp"
#define dependence right_dependence
#include "solutions/variance.cpp"
#undef dependence

namespace mc {

double dependence(std::span<const double> joint, std::size_t columns) {
  right_dependence(joint, columns);  // for what it throws
  std::vector<double> p_x(joint.size() / columns), p_y(columns);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    p_x[i / columns] += joint[i];
    p_y[i % columns] += joint[i];
  }
  double largest = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    largest = std::max(largest, std::abs(joint[i] - p_x[i / columns] * p_y[i % columns]));
  }
  return largest;
}

}  // namespace mc
