// mistake: sums where it should go along: as if the table stood column by column
// caught by: 1.7 the dependence of a joint table
// caught by: 1.7 independent variables have dependence zero
// hint: rows and columns are swapped
#include "variance.hpp"
#define dependence right_dependence
#include "solutions/variance.cpp"
#undef dependence

namespace mc {

double dependence(std::span<const double> joint, std::size_t columns) {
  right_dependence(joint, columns);  // for what it throws
  return right_dependence(joint, joint.size() / columns);
}

}  // namespace mc
