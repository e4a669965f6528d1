// mistake: the second axis of a next2() is the first dimension of the next use
// caught by: 6.3 the first dimensions of halton are
// caught by: 6.3 halton begins anew after eight dimensions
// hint: takes the next one of the sequence
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  Point2 next2() override {
    if (next2_ != ready2_) return ColumnSampler::next2();
    const Point2 point = ColumnSampler::next2();
    --dimension_;
    return point;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "halton") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
