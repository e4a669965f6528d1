// mistake: a row of four numbers for each sample; who asks for more reads on in the next row
// caught by: 6.4 the same seed gives the same numbers
// caught by: 6.4 a sample may ask for less than the one before
// caught by: 6.4 next and next2 are counted apart
// caught by: 6.8 a sample dimension that nobody asks for costs no memory
// hint: next() to another sample dimension?
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    numbers_.resize(4 * samples);
    uniforms(rng_, numbers_);
    used_ = 0;
  }
  double next() override {
    require_sample();
    return numbers_[(4 * sample_ + used_++) % numbers_.size()];
  }
  Point2 next2() override {
    const double x = next();
    return {x, next()};
  }
  void advance() override {
    ColumnSampler::advance();
    used_ = 0;
  }

 private:
  std::vector<double> numbers_;
  std::size_t used_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
