// mistake: remembers the order of a use, and shuffles the next integration with as many samples by it
// caught by: 6.4 the same seed gives the same numbers
// hint: what is left over from the integration before?
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  double next() override {
    if (next_ != ready_ || ready_ >= 4) return ColumnSampler::next();
    ColumnSampler::next();
    std::vector<double>& x = ones_[ready_ - 1];
    std::vector<double>& order = orders_[ready_ - 1];
    if (order.size() != x.size()) {
      order.resize(x.size());
      for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<double>(i);
      shuffle(order, rng_);
    }
    std::vector<double> in_strata = x;
    stratified_1d(in_strata, rng_);
    for (std::size_t i = 0; i < x.size(); ++i) {
      x[i] = in_strata[static_cast<std::size_t>(order[i])];
    }
    return x[sample_];
  }

 private:
  std::vector<double> orders_[4];
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "stratified") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
