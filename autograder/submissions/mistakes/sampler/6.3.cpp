// Mistakes in task 6.3.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

constexpr Sequence blocks_of_8{sobol_block, in_pairs, random_order};

/// The points in an order that seed_of(rng, dim) gives, after a new start.
using SeedOf = std::uint64_t(Rng& rng, const SampleDimension& dim);
template <Randomized fill, SeedOf* seed_of>
void reordered(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  std::size_t place = dim.place;
  for (const auto& column : {x, y}) {
    if (column.empty()) continue;
    std::vector<double> order;
    if (!dim.order.empty()) {
      Rng of(seed_of(rng, dim));
      order = random_order(x.size(), of);
    }
    fill({dim.number, place, dim.dimensions, order, dim.tables}, place, column, rng());
    ++place;
  }
}
std::uint64_t same_order(Rng&, const SampleDimension&) {
  return 1;
}
std::uint64_t own_order(Rng& rng, const SampleDimension&) {
  return rng();
}

/// The sequence's own order after each new start.
std::vector<double> no_order(std::size_t, Rng&) {
  return {};
}
constexpr Sequence without_order{sobol_block, in_pairs, no_order};

/// After a new start with the scrambles of the first round.
template <Randomized fill>
void alike(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  static std::uint64_t seeds[joe_kuo.size()];
  std::size_t place = dim.place;
  for (const auto& column : {x, y}) {
    if (column.empty()) continue;
    if (dim.order.empty()) seeds[place] = rng();
    fill(dim, place, column, seeds[place]);
    ++place;
  }
}

}  // namespace
}  // namespace mc

// mistake: starts both next() and next2() with dimension 0
// hint: with one counter for both
namespace mc::dimensions_counted_apart {
void apart(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  const std::size_t place = (y.empty() ? dim.number : 2 * dim.number) % joe_kuo.size();
  dimensions_of<fill_sobol>({dim.number, place, {}, {}, dim.tables}, x, y, rng);
}

MAKE_SAMPLER(make_wrong<apart, nullptr>("sobol", kind))
}  // namespace mc::dimensions_counted_apart

// mistake: permutes the digits in base 2 too, which is a digital shift
// hint: permuted digits are only a digital shift
namespace mc::halton_by_digital_shift {
void permuted(const SampleDimension& dim, std::size_t place, std::span<double> x,
              std::uint64_t seed) {
  in_order(dim, x, [&](std::span<double> all) {
    radical_inverses_scrambled(primes(joe_kuo.size())[place], 0, all, seed);
  });
}

MAKE_SAMPLER(make_wrong<dimensions_of<permuted>>("halton", kind))
}  // namespace mc::halton_by_digital_shift

// mistake: starts with point 1 of the sequence, not point 0
// hint: use the sequence from index 0
namespace mc::halton_from_one {
void from_one(const SampleDimension& dim, std::size_t place, std::span<double> x,
              std::uint64_t seed) {
  const std::vector<unsigned> bases = primes(joe_kuo.size());
  in_order(dim, x, [&](std::span<double> all) {
    if (place > 0) return radical_inverses_scrambled(bases[place], 1, all, seed);
    radical_inverses(2, 1, all);
  });
  if (place == 0) owen_scramble(x, seed);
}

MAKE_SAMPLER(make_wrong<dimensions_of<from_one>>("halton", kind))
}  // namespace mc::halton_from_one

// mistake: starts again with the same scrambles, but in another order
// hint: numbers repeat for another seed, dimension
namespace mc::halton_scrambled_alike {
MAKE_SAMPLER(make_wrong<alike<fill_halton>, &blocks_of_8>("halton", kind))
}  // namespace mc::halton_scrambled_alike

// mistake: uses the same order at each new start
// hint: use a different random order for each new start
namespace mc::halton_in_one_order {
MAKE_SAMPLER(make_wrong<reordered<fill_halton, same_order>, &blocks_of_8>("halton", kind))
}  // namespace mc::halton_in_one_order

// mistake: after the last dimension but one, a next2() has that and the first one of the next start
// hint: a next2() takes both of its dimensions from the same round
namespace mc::last_dimension_and_first {
struct Wrong : Spoiled {
  Point2 next2() override {
    if (next2_ == ready2_ && places_.next + 1 == joe_kuo.size() && samples_ > 1) {
      if (ready2_ == twos_.size()) twos_.emplace_back();
      auto& [x, y] = twos_[ready2_];
      x.resize(samples_);
      y.resize(samples_);
      kind_->fill(assign(1, 0), x, {}, rng_);
      kind_->fill(assign(1, 0), y, {}, rng_);
      ++ready2_;
    }
    return ColumnSampler::next2();
  }
};

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  static constexpr Kind plain{"sobol", dimensions_of<fill_sobol>, &one_sequence};
  if (kind != plain.name) return right_make_sampler(kind);
  Spoiled::made = &plain;
  return std::make_unique<Wrong>();
}
}  // namespace mc::last_dimension_and_first

// mistake: shuffles the points of the first sequence, too
// hint: one scramble for all samples
namespace mc::first_round_shuffled {
void shuffled(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  dimensions_of<fill_sobol>(dim, x, y, rng);
  Rng order(17);
  shuffle(x, order);
  order = Rng(17);
  if (!y.empty()) shuffle(y, order);
}

MAKE_SAMPLER(make_wrong<shuffled>("sobol", kind))
}  // namespace mc::first_round_shuffled

// mistake: pads with dimensions 0 and 1 again and again
// hint: a dimension that another one has
namespace mc::pairs_of_the_first_two {
void first_two(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  dimensions_of<fill_sobol>({dim.number, 0, {}, {}, dim.tables}, x, y, rng);
}

MAKE_SAMPLER(make_wrong<first_two, nullptr>("sobol", kind))
}  // namespace mc::pairs_of_the_first_two

// mistake: throws where the sequence has no more dimensions
// hint: dimension: must be below 32
// fails: 6.4
namespace mc::no_more_than_32_dimensions {
void unlimited(const SampleDimension& dim, std::size_t place, std::span<double> x,
               std::uint64_t seed) {
  sobol(static_cast<unsigned>(dim.order.empty() ? place : place + joe_kuo.size()), 0, x);
  owen_scramble(x, seed);
}

MAKE_SAMPLER(make_wrong<dimensions_of<unlimited>>("sobol", kind))
}  // namespace mc::no_more_than_32_dimensions

// mistake: scrambles both axes of a next2() with the same seed
// hint: use owen_scramble of lab 5, with a different seed for each dimension
// hint: one seed is used for several dimensions
namespace mc::one_scramble_for_both_axes {
void same_seed(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  const std::uint64_t seed = rng();
  fill_sobol(dim, dim.place, x, seed);
  if (!y.empty()) fill_sobol(dim, dim.place + 1, y, seed);
}

MAKE_SAMPLER(make_wrong<same_seed>("sobol", kind))
}  // namespace mc::one_scramble_for_both_axes

// mistake: does not scramble the Sobol' sequence
// hint: an unscrambled sequence begins at the origin
namespace mc::sobol_as_it_is {
void plain(const SampleDimension& dim, std::size_t place, std::span<double> x, std::uint64_t) {
  in_order(dim, x, [&](std::span<double> all) { sobol(static_cast<unsigned>(place), 0, all); });
}

MAKE_SAMPLER(make_wrong<dimensions_of<plain>>("sobol", kind))
}  // namespace mc::sobol_as_it_is

// mistake: flips the same bits of all points of a dimension
// hint: a digital shift flips a bit of all points in the same way
namespace mc::sobol_by_digital_shift {
void shifted(const SampleDimension& dim, std::size_t place, std::span<double> x,
             std::uint64_t seed) {
  in_order(dim, x, [&](std::span<double> all) { sobol(static_cast<unsigned>(place), 0, all); });
  const std::uint64_t shift = seed >> 11;
  for (double& value : x) {
    value = static_cast<double>(static_cast<std::uint64_t>(value * 0x1p53) ^ shift) * 0x1p-53;
  }
}

MAKE_SAMPLER(make_wrong<dimensions_of<shifted>>("sobol", kind))
}  // namespace mc::sobol_by_digital_shift

// mistake: starts again in the sequence's order
// hint: shuffle them at each new start
namespace mc::sobol_goes_round {
MAKE_SAMPLER(make_wrong<dimensions_of<fill_sobol>, &without_order>("sobol", kind))
}  // namespace mc::sobol_goes_round

// mistake: permutes each column separately after a new start
// hint: permute all columns of such a round in the same way
namespace mc::sobol_shuffled_apart {
MAKE_SAMPLER(make_wrong<reordered<fill_sobol, own_order>>("sobol", kind))
}  // namespace mc::sobol_shuffled_apart

// mistake: has sequences of up to 65,536 points, and repeats them
// hint: do indices fit into their type?
namespace mc::indices_of_16_bits {
void repeated(const SampleDimension& dim, std::size_t place, std::span<double> x,
              std::uint64_t seed) {
  fill_sobol(dim, place, x, seed);
  for (std::size_t i = std::size_t{1} << 16; i < x.size(); ++i) x[i] = x[i - (1 << 16)];
}

MAKE_SAMPLER(make_wrong<dimensions_of<repeated>>("sobol", kind))
}  // namespace mc::indices_of_16_bits
