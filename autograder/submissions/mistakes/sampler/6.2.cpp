// Mistakes in task 6.2.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

// mistake: shuffles next(), but leaves the points of next2() in the order of their cells
// hint: the pattern must be shuffled
namespace mc::canonical_points_for_next2 {
void in_order(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
}
MAKE_SAMPLER(make_other_kind<stratified1, in_order>("stratified", kind))
}  // namespace mc::canonical_points_for_next2

// mistake: stores stratified columns as floats, to save memory
// hint: edges are i / n, divided in double
namespace mc::columns_of_floats {
void keep_floats(std::span<double> x) {
  for (double& value : x) value = std::min(static_cast<float>(value), 0x1.fffffep-1f);
}

void one_column(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  stratified1(dim, x, rng);
  keep_floats(x);
}

void two_columns(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  stratified2(dim, x, y, rng);
  keep_floats(x);
  keep_floats(y);
}

MAKE_SAMPLER(make_other_kind<one_column, two_columns>("stratified", kind))
}  // namespace mc::columns_of_floats

// mistake: shuffles x and y of a multi-jittered pattern separately
// hint: x and y must be shuffled together
namespace mc::shuffled_apart {
void apart(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
  shuffle(x, rng);
  shuffle(y, rng);
}

MAKE_SAMPLER(make_other_kind<stratified1, apart>("stratified", kind))
}  // namespace mc::shuffled_apart
