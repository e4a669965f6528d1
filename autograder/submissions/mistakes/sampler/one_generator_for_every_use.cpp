// mistake: begins with the same generator for every sample dimension
// caught by: 6.1 numbers are uniform and independent
// caught by: 6.2 each sample dimension has a permutation of its own
// caught by: 6.3 each seed and each dimension
// caught by: 6.3 sobol begins anew after eight dimensions
// caught by: 6.3 halton begins anew after eight dimensions
// caught by: 6.4 the same seed gives the same numbers
// caught by: 6.4 a sample may ask for less than the one before
// caught by: 6.4 next and next2 are counted apart
// caught by: 6.8 a sample dimension that nobody asks for costs no memory
// hint: the same numbers come again for another
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    first_ = rng_;
  }
  double next() override {
    if (next_ == ready_) rng_ = first_;
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (next2_ == ready2_) rng_ = first_;
    return ColumnSampler::next2();
  }

 private:
  Rng first_{0};
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
