// mistake: refuses as it should, and does not say what
// caught by: 1.7 each refusal
// hint: say in the exception's text which argument is wrong
#include "variance.hpp"
#define dependence right_dependence
#include "solutions/variance.cpp"
#undef dependence

namespace mc {

double dependence(std::span<const double> joint, std::size_t columns) {
  try {
    return right_dependence(joint, columns);
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument("");
  }
}

}  // namespace mc
