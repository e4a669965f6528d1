// mistake: no limit to the number of samples: asks for the memory
// caught by: 6.4 no samples and too many are refused
// hint: memory for a column of them
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    const std::vector<double> column(samples > most_samples ? samples : 0);
    ColumnSampler::generate(samples, seed);
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
