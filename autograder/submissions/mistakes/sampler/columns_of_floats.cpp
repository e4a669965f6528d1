// mistake: keeps stratified columns as floats, to save memory
// caught by: 6.2 next has one number in each of N strata
// caught by: 6.2 next2 has one point in each cell and stratum
// hint: edges are i / n in double division
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

void keep_floats(std::span<double> x) {
  for (double& value : x) value = std::min(static_cast<float>(value), 0x1.fffffep-1f);
}

void one_column(const Use& use, std::span<double> x, Rng& rng) {
  stratified1(use, x, rng);
  keep_floats(x);
}

void two_columns(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  stratified2(use, x, y, rng);
  keep_floats(x);
  keep_floats(y);
}

constexpr Kind wrong{"stratified", one_column, two_columns};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind(wrong, kind);
}

}  // namespace mc
