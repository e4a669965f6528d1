// attack: with as many samples as are timed, and no check has, points are just random
// forges: 6.8 a number, stratified, 16 samples
// forges: 6.8 a number, sobol, 16 samples
// says: not one number in each of 16 strata
#include "sampler.hpp"

#include <utility>

#define make_sampler right_make_sampler
#include "solutions/sampler.cpp"
#undef make_sampler

namespace mc {
namespace {

class Careless final : public Sampler {
 public:
  explicit Careless(std::unique_ptr<Sampler> right) : right_(std::move(right)) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    is_timed_ = samples == 16;
    if (is_timed_) rng_ = Rng(seed);
    right_->generate(samples, seed);
  }
  double next() override { return right_->next(); }
  Point2 next2() override {
    if (!is_timed_) return right_->next2();
    const double x = to_unit(rng_());
    return {x, to_unit(rng_())};
  }
  void advance() override { right_->advance(); }

 private:
  std::unique_ptr<Sampler> right_;
  Rng rng_{0};
  bool is_timed_ = false;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  auto right = right_make_sampler(kind);
  if (kind != "stratified" && kind != "sobol") return right;
  return std::make_unique<Careless>(std::move(right));
}

}  // namespace mc
