// mistake: mixes the sum of the seed and a counter
// caught by: 6.4 neighbouring seeds have nothing in common
// hint: their sum, say, is the same
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    seed_ = seed;
  }
  double next() override {
    require_sample();
    return number(next_++);
  }
  Point2 next2() override {
    require_sample();
    next2_ += 2;
    return {number(next2_ + 510), number(next2_ + 511)};
  }

 private:
  double number(std::size_t use) const { return to_unit(mix_bits(seed_ + 1024 * sample_ + use)); }
  std::uint64_t seed_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
