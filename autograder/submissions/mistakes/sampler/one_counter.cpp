// mistake: next() and next2() are counted together: a next() is half of a next2()
// caught by: 6.3 the first dimensions of sobol are
// caught by: 6.3 the first dimensions of halton are
// caught by: 6.3 sobol begins anew
// caught by: 6.3 halton begins anew
// caught by: 6.4 next and next2 are counted apart
// caught by: 6.7 the first next2 is blue noise
// hint: count the calls of next() and those of next2() in counters of their own
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  double next() override { return next2().x; }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}

}  // namespace mc
