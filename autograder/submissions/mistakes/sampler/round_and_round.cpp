// mistake: begins with the first sample again after the last one
// caught by: 6.4 there are numbers for N samples and no others
// hint: next() and next2() need a sample
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void advance() override {
    next_ = next2_ = 0;
    if (samples_ > 0) sample_ = (sample_ + 1) % samples_;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
