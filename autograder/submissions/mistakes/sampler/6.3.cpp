// Mistakes in task 6.3.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

// Mistakes of both sequences.

/// The same in another order: none, or one by the seed that seed_of(rng, n) returns.
using SeedOf = std::uint64_t(Rng& rng, std::size_t n);
template <Randomized fill, SeedOf* seed_of>
void fill_block(const SampleDimension& dim, std::size_t place, std::span<double> x, Rng& rng) {
  if (dim.order.empty()) return fill(dim, place, x, rng());
  std::vector<std::uint32_t> order;
  if (seed_of != nullptr) order = nested_order(x.size(), seed_of(rng, x.size()));
  fill({dim.number, dim.of_sequence, order, dim.tables}, place, x, rng());
}
template <Randomized fill, SeedOf* seed_of>
void one_by(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  fill_block<fill, seed_of>(dim, dim.of_sequence % block, x, rng);
}
template <Randomized fill, SeedOf* seed_of>
void two_by(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  fill_block<fill, seed_of>(dim, dim.of_sequence % block, x, rng);
  fill_block<fill, seed_of>(dim, dim.of_sequence % block + 1, y, rng);
}
std::uint64_t same_order(Rng&, std::size_t n) {
  return n;
}
std::uint64_t own_order(Rng& rng, std::size_t) {
  return rng();
}

/// Each block but the first in a uniform permutation, which all its dimensions share.
template <Randomized fill>
void one_shuffled(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  fill({dim.number, dim.of_sequence, {}, dim.tables}, dim.of_sequence % block, x, rng());
  if (dim.order.empty()) return;
  std::uint64_t seed = 0;  // of the block
  for (const std::uint32_t index : dim.order) seed = mix_bits(seed ^ index);
  Rng order(seed);
  shuffle(x, order);
}
template <Randomized fill>
void two_shuffled(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  one_shuffled<fill>(dim, x, rng);
  one_shuffled<fill>({dim.number, dim.of_sequence + 1, dim.order, dim.tables}, y, rng);
}

constexpr std::size_t dimensions = joe_kuo.size();

using Scrambled = void(std::size_t dimension, std::span<double> x, Rng& rng);
template <Scrambled fill>
void one_of_32(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  if (dim.of_sequence < dimensions) return fill(dim.of_sequence, x, rng);
  fill(0, x, rng);
  shuffle(x, rng);
}
template <Scrambled fill>
void two_of_32(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  const bool padded = dim.of_sequence + 2 > dimensions;
  fill(padded ? 0 : dim.of_sequence, x, rng);
  fill(padded ? 1 : dim.of_sequence + 1, y, rng);
  if (!padded) return;
  Rng again = rng;
  shuffle(x, rng);
  shuffle(y, again);
}
void scrambled_halton(std::size_t dimension, std::span<double> x, Rng& rng) {
  const std::vector<unsigned> bases = primes(dimensions);
  if (dimension > 0) return radical_inverses_scrambled(bases[dimension], 0, x, rng());
  radical_inverses(2, 0, x);
  owen_scramble(x, rng());
}
void scrambled_sobol(std::size_t dimension, std::span<double> x, Rng& rng) {
  sobol(static_cast<unsigned>(dimension), 0, x);
  owen_scramble(x, rng());
}

/// Blocks whose dimensions have the same scrambles in each.
template <Randomized fill>
void one_alike(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  static std::uint64_t seeds[block];
  if (dim.of_sequence < block) seeds[dim.of_sequence] = rng();
  fill(dim, dim.of_sequence % block, x, seeds[dim.of_sequence % block]);
}
template <Randomized fill>
void two_alike(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  one_alike<fill>(dim, x, rng);
  one_alike<fill>({dim.number, dim.of_sequence + 1, dim.order, dim.tables}, y, rng);
}

}  // namespace
}  // namespace mc

// mistake: starts both next() and next2() with dimension 0
// hint: a new next2() takes the next pair of the block
namespace mc::dimensions_counted_apart {
void one(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  one_of<fill_sobol>({dim.number, dim.number, dim.order, dim.tables}, x, rng);
}
void two(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  two_of<fill_sobol>({dim.number, 2 * dim.number, dim.order, dim.tables}, x, y, rng);
}

MAKE_SAMPLER(make_other_kind<one, two>("sobol", kind))
}  // namespace mc::dimensions_counted_apart

// mistake: does not permute the digits of the Halton sequence
// hint: an unscrambled sequence begins at the origin
namespace mc::halton_as_it_is {
void plain(const SampleDimension& dim, std::size_t place, std::span<double> x, std::uint64_t) {
  in_order(dim, x, [&](std::span<double> all) { radical_inverses(primes(block)[place], 0, all); });
}

MAKE_SAMPLER(make_other_kind<one_of<plain>, two_of<plain>>("halton", kind))
}  // namespace mc::halton_as_it_is

// mistake: reuses the scrambles of the first block in every block, with other permutations
// hint: numbers repeat for another seed, dimension
namespace mc::halton_blocks_scrambled_alike {
MAKE_SAMPLER(make_other_kind<one_alike<fill_halton>, two_alike<fill_halton>>("halton", kind))
}  // namespace mc::halton_blocks_scrambled_alike

// mistake: permutes the digits in base 2 too, which is a digital shift
// hint: a digital shift
namespace mc::halton_by_digital_shift {
void permuted(const SampleDimension& dim, std::size_t place, std::span<double> x,
              std::uint64_t seed) {
  const std::vector<unsigned> bases = primes(block);
  in_order(dim, x,
           [&](std::span<double> all) { radical_inverses_scrambled(bases[place], 0, all, seed); });
}

MAKE_SAMPLER(make_other_kind<one_of<permuted>, two_of<permuted>>("halton", kind))
}  // namespace mc::halton_by_digital_shift

// mistake: starts with point 1 of the sequence, not point 0
// hint: use the sequence from index 0
namespace mc::halton_from_one {
void from_one(const SampleDimension& dim, std::size_t place, std::span<double> x,
              std::uint64_t seed) {
  const std::vector<unsigned> bases = primes(block);
  in_order(dim, x, [&](std::span<double> all) {
    if (place > 0) return radical_inverses_scrambled(bases[place], 1, all, seed);
    radical_inverses(2, 1, all);
  });
  if (place == 0) owen_scramble(x, seed);
}

MAKE_SAMPLER(make_other_kind<one_of<from_one>, two_of<from_one>>("halton", kind))
}  // namespace mc::halton_from_one

// mistake: starts again with dimension 0 after the eighth, without a permutation
// hint: shuffle every block except the first
namespace mc::halton_goes_round {
MAKE_SAMPLER(make_other_kind<one_by<fill_halton, nullptr>, two_by<fill_halton, nullptr>>("halton",
                                                                                         kind))
}  // namespace mc::halton_goes_round

// mistake: uses the same permutation for all blocks but the first
// hint: use a different random order for each block
namespace mc::halton_padded_in_one_order {
MAKE_SAMPLER(make_other_kind<one_by<fill_halton, same_order>, two_by<fill_halton, same_order>>(
    "halton", kind))
}  // namespace mc::halton_padded_in_one_order

// mistake: permutes each column separately beyond the first eight dimensions
// hint: all dimensions of a block must share one order
namespace mc::halton_shuffled_apart {
MAKE_SAMPLER(
    make_other_kind<one_by<fill_halton, own_order>, two_by<fill_halton, own_order>>("halton", kind))
}  // namespace mc::halton_shuffled_apart

// mistake: uses 32 dimensions; beyond them, the first one or two again, shuffled
// hint: these are dimensions 8 to 15
namespace mc::halton_without_blocks {
MAKE_SAMPLER(make_other_kind<one_of_32<scrambled_halton>, two_of_32<scrambled_halton>>("halton",
                                                                                       kind))
}  // namespace mc::halton_without_blocks

// mistake: takes dimension after dimension: after a next(), a next2() has halves of two pairs
// hint: a new next2() takes the next pair of the block
namespace mc::last_dimension_and_first {
struct Wrong : ColumnSampler {
  using ColumnSampler::ColumnSampler;
  Point2 next2() override {
    if (next2_ == ready2_ && half_ > 0) {
      require_sample();
      if (ready2_ == twos_.size()) twos_.emplace_back();
      Pair& pair = twos_[ready2_++];
      pair.x.resize(samples_);
      pair.y.resize(samples_);
      one_of<fill_sobol>(assign(1, 0), pair.x, rng_);
      one_of<fill_sobol>(assign(1, 0), pair.y, rng_);
    }
    return ColumnSampler::next2();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "sobol"))
}  // namespace mc::last_dimension_and_first

// mistake: takes dimensions 0 to 7 of the Sobol' sequence, with bad pairs among them
// hint: a new next2() takes the next pair of the block
namespace mc::sobol_dimensions_in_order {
void eight(const SampleDimension& dim, std::size_t place, std::span<double> x, std::uint64_t seed) {
  in_order(dim, x, [&](std::span<double> all) { sobol(static_cast<unsigned>(place), 0, all); });
  owen_scramble(x, seed);
}

MAKE_SAMPLER(make_other_kind<one_of<eight>, two_of<eight>>("sobol", kind))
}  // namespace mc::sobol_dimensions_in_order

// mistake: shuffles later blocks uniformly, so they cannot be stopped early
// hint: a uniform shuffle spreads the first points of a block
namespace mc::blocks_shuffled_uniformly {
MAKE_SAMPLER(make_other_kind<one_shuffled<fill_sobol>, two_shuffled<fill_sobol>>("sobol", kind))
}  // namespace mc::blocks_shuffled_uniformly

// mistake: leaves out the second half of a pair that a next() has begun
// hint: the following next() the other half
namespace mc::halves_left_out {
struct Wrong : ColumnSampler {
  using ColumnSampler::ColumnSampler;
  double next() override {
    half_ = 0;
    return ColumnSampler::next();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "halton"))
}  // namespace mc::halves_left_out

// mistake: throws where the sequence has no more dimensions
// hint: dimension: must be below 32
namespace mc::no_more_than_32_dimensions {
void one(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  scrambled_sobol(dim.of_sequence, x, rng);
}
void two(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  scrambled_sobol(dim.of_sequence, x, rng);
  scrambled_sobol(dim.of_sequence + 1, y, rng);
}

MAKE_SAMPLER(make_other_kind<one, two>("sobol", kind))
}  // namespace mc::no_more_than_32_dimensions

// mistake: scrambles both axes of a next2() with the same seed
// hint: one seed is used for several dimensions
namespace mc::one_scramble_for_both_axes {
void same_seed(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  Rng again = rng;
  fill_sobol(dim, dim.of_sequence % block, x, rng());
  fill_sobol(dim, dim.of_sequence % block + 1, y, again());
}

MAKE_SAMPLER(make_other_kind<one_of<fill_sobol>, same_seed>("sobol", kind))
}  // namespace mc::one_scramble_for_both_axes

// mistake: does not scramble the Sobol' sequence
// hint: an unscrambled sequence begins at the origin
namespace mc::sobol_as_it_is {
void plain(const SampleDimension& dim, std::size_t place, std::span<double> x, std::uint64_t) {
  in_order(dim, x, [&](std::span<double> all) { sobol(sobol_block[place], 0, all); });
}

MAKE_SAMPLER(make_other_kind<one_of<plain>, two_of<plain>>("sobol", kind))
}  // namespace mc::sobol_as_it_is

// mistake: reuses the scrambles of the first block in every block, with other permutations
// hint: numbers repeat for another seed, dimension
namespace mc::sobol_blocks_scrambled_alike {
MAKE_SAMPLER(make_other_kind<one_alike<fill_sobol>, two_alike<fill_sobol>>("sobol", kind))
}  // namespace mc::sobol_blocks_scrambled_alike

// mistake: flips the same bits of all points of a dimension
// hint: owen_scramble of lab 5
namespace mc::sobol_by_digital_shift {
void shifted(const SampleDimension& dim, std::size_t place, std::span<double> x,
             std::uint64_t seed) {
  in_order(dim, x, [&](std::span<double> all) { sobol(sobol_block[place], 0, all); });
  const std::uint64_t shift = seed >> 11;
  for (double& value : x) {
    value = static_cast<double>(static_cast<std::uint64_t>(value * 0x1p53) ^ shift) * 0x1p-53;
  }
}

MAKE_SAMPLER(make_other_kind<one_of<shifted>, two_of<shifted>>("sobol", kind))
}  // namespace mc::sobol_by_digital_shift

// mistake: starts again with dimension 0 after the eighth, without a permutation
// hint: shuffle every block except the first
namespace mc::sobol_goes_round {
MAKE_SAMPLER(make_other_kind<one_by<fill_sobol, nullptr>, two_by<fill_sobol, nullptr>>("sobol",
                                                                                       kind))
}  // namespace mc::sobol_goes_round

// mistake: uses the same permutation for all blocks but the first
// hint: use a different random order for each block
namespace mc::sobol_padded_in_one_order {
MAKE_SAMPLER(
    make_other_kind<one_by<fill_sobol, same_order>, two_by<fill_sobol, same_order>>("sobol", kind))
}  // namespace mc::sobol_padded_in_one_order

// mistake: permutes each column separately beyond the first eight dimensions
// hint: all dimensions of a block must share one order
namespace mc::sobol_shuffled_apart {
MAKE_SAMPLER(make_other_kind<one_by<fill_sobol, own_order>, two_by<fill_sobol, own_order>>("sobol",
                                                                                           kind))
}  // namespace mc::sobol_shuffled_apart

// mistake: uses 32 dimensions; beyond them, the first one or two again, shuffled
// hint: these are dimensions 8 to 15
namespace mc::sobol_without_blocks {
MAKE_SAMPLER(make_other_kind<one_of_32<scrambled_sobol>, two_of_32<scrambled_sobol>>("sobol", kind))
}  // namespace mc::sobol_without_blocks
