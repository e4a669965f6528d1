// mistake: every block has the scrambles of the first, in another order
// caught by: 6.3 halton begins anew after eight dimensions
// hint: scrambled by seeds of its own
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  double next() override {
    if (next_ != ready_) return ColumnSampler::next();
    ColumnSampler::next();
    alike(ones_[ready_ - 1], dimension_ - 1);
    return ones_[ready_ - 1][sample_];
  }
  Point2 next2() override {
    if (next2_ != ready2_) return ColumnSampler::next2();
    ColumnSampler::next2();
    Pair& pair = twos_[ready2_ - 1];
    alike(pair.x, dimension_ - 2);
    alike(pair.y, dimension_ - 1);
    return {pair.x[sample_], pair.y[sample_]};
  }

 private:
  /// Keeps a column of the first block, and repeats it in every other.
  void alike(std::vector<double>& x, std::size_t dimension) {
    std::vector<double>& first = first_[dimension % block];
    if (dimension < block) first = x;
    if (dimension < block || first.size() != x.size()) return;
    x = first;
    Rng order = order_;
    shuffle(x, order);
  }
  std::array<std::vector<double>, block> first_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "halton") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
