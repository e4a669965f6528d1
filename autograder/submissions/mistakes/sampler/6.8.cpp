// Mistakes in task 6.8.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

// mistake: makes sixteen columns in generate(), requested or not
// hint: make a column when it is first requested
namespace mc::eager_columns {
struct Wrong : ColumnSampler {
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    while (next_ < 16) next();
    next_ = 0;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "stratified"))
}  // namespace mc::eager_columns
