// mistake: refuses an unknown kind without a word about the known ones
// caught by: 6.1 a refusal names the kinds
// hint: a list of the kinds helps whoever mistypes one
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  for (const Kind& known : kinds) {
    if (known.name == kind) return right_make_sampler(kind);
  }
  throw std::invalid_argument("unknown kind");
}

}  // namespace mc
