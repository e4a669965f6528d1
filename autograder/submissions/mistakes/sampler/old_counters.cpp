// mistake: generate() does not set back the counters: a sample that was left early goes on
// caught by: 6.4 the same seed gives the same numbers
// hint: Counters, columns of that size
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    const std::size_t before = next_;
    ColumnSampler::generate(samples, seed);
    while (next_ < before) next();
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "stratified") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
