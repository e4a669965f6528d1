// mistake: generate() does not go back to the first sample
// caught by: 6.4 the same seed gives the same numbers
// hint: Counters, columns of that size
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    const std::size_t before = sample_;
    ColumnSampler::generate(samples, seed);
    sample_ = before % samples;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
