// mistake: fewer samples than before get the first numbers of columns of the old size
// caught by: 6.4 the same seed gives the same numbers
// caught by: 6.8 a sample dimension that nobody asks for costs no memory
// hint: columns of that size or of another
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

#include <algorithm>

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    wanted_ = samples;
    most_ = samples_ = std::max(most_, samples);
  }
  void advance() override {
    if (sample_ + 1 >= wanted_) samples_ = wanted_;  // this was the last
    ColumnSampler::advance();
  }

 private:
  std::size_t wanted_ = 0, most_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
