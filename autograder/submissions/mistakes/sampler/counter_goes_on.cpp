// mistake: advance() sets back the counter of next(), and forgets that of next2()
// caught by: 6.1 numbers are uniform and independent
// caught by: 6.2 next2 has one point in each cell and stratum
// caught by: 6.3 the first dimensions of sobol are
// caught by: 6.3 the first dimensions of halton are
// caught by: 6.3 sobol begins anew after eight dimensions
// caught by: 6.3 halton begins anew after eight dimensions
// caught by: 6.2 each sample dimension has a permutation of its own
// caught by: 6.4 a sample may ask for less than the one before
// caught by: 6.7 the first next2 is blue noise
// hint: a sample that ends early must not hand its numbers
// limit: time
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

#include <algorithm>

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void advance() override {
    const std::size_t before = next2_;
    ColumnSampler::advance();
    next2_ = std::min(before, ready2_);
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
