// mistake: all samplers draw from one generator, which generate() seeds
// caught by: 6.4 two samplers at once share nothing
// hint: is there anything static
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

Rng shared(0);

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    shared = rng_;
  }
  double next() override {
    if (next_ != ready_) return ColumnSampler::next();
    rng_ = shared;
    const double x = ColumnSampler::next();
    shared = rng_;
    return x;
  }
  Point2 next2() override {
    if (next2_ != ready2_) return ColumnSampler::next2();
    rng_ = shared;
    const Point2 point = ColumnSampler::next2();
    shared = rng_;
    return point;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
