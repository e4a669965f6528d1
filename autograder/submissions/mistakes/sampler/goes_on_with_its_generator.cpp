// mistake: seeds its generator in the first generate() only
// caught by: 6.4 the same seed gives the same numbers
// hint: what is left over from the integration before?
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    const Rng before = rng_;
    const bool first = samples_ == 0;
    ColumnSampler::generate(samples, seed);
    if (!first) rng_ = before;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
