// mistake: takes any other name for "independent"
// caught by: 6.1 kinds that there are not are refused
// caught by: 6.1 a refusal names the kinds
// hint: there is no such kind of sampler
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  const auto known = [&](const Kind& one) { return one.name == kind; };
  const bool is_known = std::any_of(std::begin(kinds), std::end(kinds), known);
  return right_make_sampler(is_known ? kind : "independent");
}

}  // namespace mc
