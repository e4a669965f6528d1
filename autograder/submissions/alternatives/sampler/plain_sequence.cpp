// alternative: of 6.3 no more than the task asks for: the dimensions of one sequence in turn, and a
// uniform shuffle where it starts again

#include "sampler.hpp"
#define make_sampler right_make_sampler
#include "solutions/sampler.cpp"
#undef make_sampler

namespace mc {

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  for (const Kind& plain : plain_kinds) {
    if (plain.name == kind) return std::make_unique<ColumnSampler>(plain);
  }
  if (kind.starts_with("lattice")) throw std::invalid_argument("kind: lattices are optional");
  return right_make_sampler(kind);
}

}  // namespace mc
