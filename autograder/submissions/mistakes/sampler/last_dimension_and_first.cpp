// mistake: where one dimension of a block is left, a next2() takes that and the first of the next
// caught by: 6.3 sobol begins anew after eight dimensions
// hint: that is left out
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  Point2 next2() override {
    if (next2_ == ready2_ && dimension_ % block == block - 1) {
      require_sample();
      if (ready2_ == twos_.size()) twos_.emplace_back();
      Pair& pair = twos_[ready2_++];
      pair.x.resize(samples_);
      pair.y.resize(samples_);
      const Use last{0, dimension_, order_, tables_};
      one_of<fill_sobol>(last, pair.x, rng_);
      order_ = Rng(rng_());
      const Use first{0, dimension_ + 1, order_, tables_};
      one_of<fill_sobol>(first, pair.y, rng_);
      dimension_ += 2;
    }
    return ColumnSampler::next2();
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "sobol") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
