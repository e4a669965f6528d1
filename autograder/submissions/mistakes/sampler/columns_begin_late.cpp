// mistake: a sample dimension that a later sample asks for first begins with its first number then
// caught by: 6.4 a sample may ask for less than the one before
// hint: make a whole column, also for the samples before
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    begins_.clear();
  }
  double next() override {
    if (next_ == begins_.size()) begins_.push_back(sample_);
    if (next_ == ready_) return ColumnSampler::next();  // makes the column and comes back
    const std::size_t use = next_++;
    return ones_[use][sample_ - begins_[use]];
  }

 private:
  std::vector<std::size_t> begins_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
