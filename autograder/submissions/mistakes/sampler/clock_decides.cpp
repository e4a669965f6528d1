// mistake: seeds itself from the clock
// caught by: 6.4 the same seed gives the same numbers
// caught by: 6.4 a sample may ask for less than the one before
// caught by: 6.4 next and next2 are counted apart
// caught by: 6.5 the seed of integrate decides about the samples
// caught by: 6.4 two samplers at once share nothing
// hint: no clock, no global generator
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

#include <chrono>

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    ColumnSampler::generate(samples, mix_bits(seed) + static_cast<std::uint64_t>(now));
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
