// mistake: makes columns for what the first sample asks for; the others may not ask for more
// caught by: 6.4 a sample may ask for less than the one before
// hint: a sample dimension may first be asked for by a later sample
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  double next() override {
    if (sample_ > 0 && next_ == ready_) throw std::out_of_range("more than the first sample");
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (sample_ > 0 && next2_ == ready2_) throw std::out_of_range("more than the first sample");
    return ColumnSampler::next2();
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
