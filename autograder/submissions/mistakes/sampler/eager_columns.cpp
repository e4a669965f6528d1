// mistake: generate() makes sixteen columns, wanted or not
// caught by: 6.8 a use that nobody asks for costs no memory
// hint: numbers are made for uses, and there was none
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

class Wrong : public ColumnSampler {
 public:
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    while (next_ < 16) next();
    next_ = 0;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "stratified") return make_spoiled<Wrong>(kind);
  return right_make_sampler(kind);
}

}  // namespace mc
