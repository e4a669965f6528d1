// mistake: keeps its numbers as floats, to save memory
// caught by: 6.2 next has one number in each of N strata
// hint: edges are i / n in double division
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  double next() override { return static_cast<float>(ColumnSampler::next()); }
  Point2 next2() override {
    const Point2 point = ColumnSampler::next2();
    return {static_cast<float>(point.x), static_cast<float>(point.y)};
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
