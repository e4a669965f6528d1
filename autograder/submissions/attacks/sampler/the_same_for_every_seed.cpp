// attack: a sampler that was asked a hundred times for as many samples gives the first ones again
// forges: 6.8 a number, stratified, 16 samples
// forges: 6.8 a number, sobol, 64 samples
// says: when judged
#include "sampler.hpp"

#include <utility>

#define make_sampler right_make_sampler
#include "solutions/sampler.cpp"
#undef make_sampler

namespace mc {
namespace {

class Forgetful final : public Sampler {
 public:
  explicit Forgetful(std::unique_ptr<Sampler> right) : right_(std::move(right)) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    times_ = samples == samples_ && samples > 1 ? times_ + 1 : 0;
    at_ = 0;
    if (times_ < 100) {
      right_->generate(samples, seed);
      known_.clear();
    }
    samples_ = samples;
  }
  double next() override { return right_->next(); }
  Point2 next2() override {
    if (times_ < 100 || at_ == known_.size()) known_.push_back(right_->next2());
    return known_[at_++];
  }
  void advance() override {
    if (times_ < 100) right_->advance();
  }

 private:
  std::unique_ptr<Sampler> right_;
  std::vector<Point2> known_;
  std::size_t samples_ = 0, at_ = 0, times_ = 0;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return std::make_unique<Forgetful>(right_make_sampler(kind));
}

}  // namespace mc
