// mistake: takes negative and NaN weights as they come
// caught by: 1.7 what is no distribution
// caught by: 1.7 each refusal names
// hint: misuse throws std::invalid_argument
#include "variance.hpp"
#define dependence right_dependence
#include "solutions/variance.cpp"
#undef dependence

namespace mc {

double dependence(std::span<const double> joint, std::size_t columns) {
  std::vector<double> weights(joint.begin(), joint.end());
  for (double& weight : weights) weight = weight > 0 ? weight : 0;
  return right_dependence(weights, columns);
}

}  // namespace mc
