// mistake: hands out 0 where there is no sample
// caught by: 6.4 there are numbers for N samples and no others
// hint: next() and next2() need a sample
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  double next() override { return sample_ < samples_ ? ColumnSampler::next() : 0; }
  Point2 next2() override { return sample_ < samples_ ? ColumnSampler::next2() : Point2{}; }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
