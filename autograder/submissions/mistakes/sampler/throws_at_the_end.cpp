// mistake: advance() throws where there is no sample to move on to
// caught by: 6.4 there are numbers for N samples and no others
// hint: advance() never throws
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void advance() override {
    require_sample();
    ColumnSampler::advance();
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
