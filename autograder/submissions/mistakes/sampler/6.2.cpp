// Mistakes in task 6.2.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

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
  stratified(dim, x, y, rng);
  keep_floats(x);
  keep_floats(y);
}

MAKE_SAMPLER(make_other_kind<one_column, two_columns>("stratified", kind))
}  // namespace mc::columns_of_floats

// mistake: shuffles x and y of a multi-jittered pattern separately
// hint: two 1D patterns are not a 2D pattern: fill the cells of the grid
namespace mc::shuffled_apart {
void apart(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
  shuffle(x, rng);
  shuffle(y, rng);
}

MAKE_SAMPLER(make_other_kind<stratified1, apart>("stratified", kind))
}  // namespace mc::shuffled_apart

// mistake: does not shuffle: sample i is in stratum i of every sample dimension
// hint: the pattern must be shuffled
namespace mc::strata_in_order {
void one(const SampleDimension&, std::span<double> x, Rng& rng) {
  stratified_1d(x, rng);
}
void two(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
}

MAKE_SAMPLER(make_other_kind<one, two>("stratified", kind))
}  // namespace mc::strata_in_order

// mistake: shuffles every sample dimension by the same permutation
// hint: shuffle each one separately
namespace mc::one_shuffle_for_all {
void one(const SampleDimension&, std::span<double> x, Rng& rng) {
  stratified_1d(x, rng);
  Rng always(x.size());
  shuffle(x, always);
}

void two(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
  Rng always(x.size());
  shuffle_points(x, y, always);
}

MAKE_SAMPLER(make_other_kind<one, two>("stratified", kind))
}  // namespace mc::one_shuffle_for_all

// mistake: a next2() has one point in each cell, and leaves the strata of the axes to chance
// hint: multi-jittered points (3.7) also have one in each stratum
namespace mc::only_jittered {
void two(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  stratified_2d(x, y, strata(x.size()), rng);
  shuffle_points(x, y, rng);
}

MAKE_SAMPLER(make_other_kind<stratified1, two>("stratified", kind))
}  // namespace mc::only_jittered

// mistake: takes the centers of strata
// hint: in every set: draw it from the given generator
namespace mc::centers_of_strata {
void one(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  stratified1(dim, x, rng);
  const auto n = static_cast<double>(x.size());
  for (double& value : x) value = (std::floor(value * n) + 0.5) / n;
}

MAKE_SAMPLER(make_other_kind<one, stratified>("stratified", kind))
}  // namespace mc::centers_of_strata

// mistake: shuffles by swapping each sample with any other
// hint: swapped with any of the n values
namespace mc::swaps_with_any {
void one(const SampleDimension&, std::span<double> x, Rng& rng) {
  stratified_1d(x, rng);
  for (double& value : x) std::swap(value, x[rng() % x.size()]);
}

MAKE_SAMPLER(make_other_kind<one, stratified>("stratified", kind))
}  // namespace mc::swaps_with_any
