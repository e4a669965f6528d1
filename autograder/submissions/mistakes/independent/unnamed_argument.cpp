// mistake: refuses without a word on what is wrong
// caught by: 2.6 every refusal
// hint: say in the exception's text which argument is wrong
#include "independent.hpp"

#define samples_for right_samples_for
#include "solutions/independent.cpp"
#undef samples_for

namespace mc {

std::uint64_t samples_for(const Estimate& pilot, double target_error) {
  try {
    return right_samples_for(pilot, target_error);
  } catch (const std::invalid_argument&) {
    throw std::invalid_argument("bad input");
  }
}

}  // namespace mc
