// mistake: refuses by another exception than the one that is promised
// caught by: 1.7 what is no distribution
// caught by: 1.7 each refusal
// hint: threw another exception
#include "variance.hpp"
#define dependence right_dependence
#include "solutions/variance.cpp"
#undef dependence

namespace mc {

double dependence(std::span<const double> joint, std::size_t columns) {
  try {
    return right_dependence(joint, columns);
  } catch (const std::invalid_argument& error) {
    throw std::domain_error(error.what());
  }
}

}  // namespace mc
