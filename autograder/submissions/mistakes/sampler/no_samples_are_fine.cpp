// mistake: takes 0 for a number of samples
// caught by: 6.4 no samples and too many are refused
// hint: there must be samples
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples > 0) return ColumnSampler::generate(samples, seed);
    samples_ = sample_ = next_ = next2_ = ready_ = ready2_ = 0;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
