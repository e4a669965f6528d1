// mistake: the upper half of the seed is lost
// caught by: 6.4 neighbouring seeds have nothing in common
// hint: was the seed cut to 32 bits?
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, static_cast<unsigned>(seed));
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
