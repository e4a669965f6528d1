// mistake: the first number is one step of a linear congruential generator from the seed
// caught by: 6.4 neighbouring seeds have nothing in common
// hint: mix the bits of the seed
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;

  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    first_ = to_unit((seed + 1) * 6364136223846793005u + 1442695040888963407u);
  }
  double next() override {
    const double x = ColumnSampler::next();  // the right numbers, but for the first
    return sample_ == 0 && next_ == 1 ? first_ : x;
  }

 private:
  double first_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
