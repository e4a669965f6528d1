// mistake: draws number after number from one generator, as random() does
// caught by: 6.4 a sample may ask for less than the one before
// caught by: 6.4 next and next2 are counted apart
// hint: must not hand its numbers to the next one
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  double next() override {
    require_sample();
    return to_unit(rng_());
  }
  Point2 next2() override {
    const double x = next();
    return {x, next()};
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
