// mistake: takes the seed for the state of a linear congruential generator
// caught by: 6.1 numbers are uniform and independent
// caught by: 6.4 the same seed gives the same numbers
// caught by: 6.4 a sample may ask for less than the one before
// caught by: 6.4 next and next2 are counted apart
// caught by: 6.4 neighbouring seeds have nothing in common
// caught by: 6.5 every kind is unbiased on every scene
// hint: mix the bits of the seed
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    state_ = seed;
  }
  double next() override {
    if (next_ == ready_) rng_ = Rng::constant(0);  // only its place among the uses counts
    const double x = ColumnSampler::next();
    (void)x;
    const std::uint64_t at = state_ + sample_ * 0x9e3779b97f4a7c15u + next_ * 0xd1342543de82ef95u;
    return to_unit(at * 6364136223846793005u + 1442695040888963407u);
  }

 private:
  std::uint64_t state_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
