// mistake: a use's generator has the integration's seed plus the number of the use
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
    if (next_ == ready_) rng_ = Rng(seed_ + ready_ + ready2_);
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (next2_ == ready2_) rng_ = Rng(seed_ + ready_ + ready2_);
    return ColumnSampler::next2();
  }

 private:
  std::uint64_t seed_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
