// mistake: keeps the columns where the number of samples is that of before
// caught by: 6.4 the same seed gives the same numbers
// hint: what is left over from the integration before?
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    const bool same = samples == samples_ && sample_ < samples_;
    const std::size_t ready = ready_, ready2 = ready2_;
    ColumnSampler::generate(samples, seed);
    if (!same) return;
    ready_ = ready;
    ready2_ = ready2;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
