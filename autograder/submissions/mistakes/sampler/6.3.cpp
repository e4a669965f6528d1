// Mistakes in task 6.3.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

namespace mc {
namespace {

// Mistakes of both sequences.

template <Randomised fill>
void one_in_a_circle(const Use& use, std::span<double> x, Rng& rng) {
  fill(use.dimension % block, x, rng(), use.tables);
}
template <Randomised fill>
void two_in_a_circle(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  fill(use.dimension % block, x, rng(), use.tables);
  fill(use.dimension % block + 1, y, rng(), use.tables);
}

/// Shuffles by the generator that order_of(rng, n) returns.
using OrderOf = Rng(Rng& rng, std::size_t n);
template <Randomised fill, OrderOf order_of>
void fill_block(const Use& use, std::size_t dimension, std::span<double> x, Rng& rng) {
  fill(dimension % block, x, rng(), use.tables);
  if (dimension < block) return;
  Rng order = order_of(rng, x.size());
  shuffle(x, order);
}
template <Randomised fill, OrderOf order_of>
void one_by(const Use& use, std::span<double> x, Rng& rng) {
  fill_block<fill, order_of>(use, use.dimension, x, rng);
}
template <Randomised fill, OrderOf order_of>
void two_by(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  fill_block<fill, order_of>(use, use.dimension, x, rng);
  fill_block<fill, order_of>(use, use.dimension + 1, y, rng);
}
Rng same_order(Rng&, std::size_t n) {
  return Rng(n);
}
Rng own_order(Rng& rng, std::size_t) {
  return Rng(rng());
}

constexpr std::size_t dimensions = joe_kuo.size();

using Scrambled = void(std::size_t dimension, std::span<double> x, Rng& rng);
template <Scrambled fill>
void one_of_32(const Use& use, std::span<double> x, Rng& rng) {
  if (use.dimension < dimensions) return fill(use.dimension, x, rng);
  fill(0, x, rng);
  shuffle(x, rng);
}
template <Scrambled fill>
void two_of_32(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  const bool padded = use.dimension + 2 > dimensions;
  fill(padded ? 0 : use.dimension, x, rng);
  fill(padded ? 1 : use.dimension + 1, y, rng);
  if (!padded) return;
  Rng again = rng;
  shuffle(x, rng);
  shuffle(y, again);
}
void scrambled_halton(std::size_t dimension, std::span<double> x, Rng& rng) {
  static const std::vector<unsigned> bases = primes(dimensions);
  if (dimension > 0) return radical_inverses_scrambled(bases[dimension], 0, x, rng());
  radical_inverses(2, 0, x);
  owen_scramble(x, rng());
}
void scrambled_sobol(std::size_t dimension, std::span<double> x, Rng& rng) {
  sobol(static_cast<unsigned>(dimension), 0, x);
  owen_scramble(x, rng());
}

struct BlocksAlike : ColumnSampler {
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
}  // namespace mc

// mistake: starts both next() and next2() with dimension 0
// hint: takes the next one of the sequence
namespace mc::dimensions_counted_apart {
void one(const Use& use, std::span<double> x, Rng& rng) {
  one_of<fill_sobol>({use.number, use.number, use.order, use.tables}, x, rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  two_of<fill_sobol>({use.number, 2 * use.number, use.order, use.tables}, x, y, rng);
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one, two>("sobol", kind);
}
}  // namespace mc::dimensions_counted_apart

// mistake: does not permute the digits of the Halton sequence
// hint: a sequence as it is has the origin for its first point
namespace mc::halton_as_it_is {
void plain(std::size_t dimension, std::span<double> x, std::uint64_t, Tables&) {
  radical_inverses(primes(block)[dimension], 0, x);
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of<plain>, two_of<plain>>("halton", kind);
}
}  // namespace mc::halton_as_it_is

// mistake: reuses the scrambles of the first block in every block, with other permutations
// hint: scrambled by seeds of its own
namespace mc::halton_blocks_scrambled_alike {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return kind == "halton" ? make_spoiled<BlocksAlike>(kind) : right_make_sampler(kind);
}
}  // namespace mc::halton_blocks_scrambled_alike

// mistake: permutes the digits in base 2 too, which is a digital shift
// hint: a digital shift
namespace mc::halton_by_digital_shift {
void permuted(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables&) {
  static const std::vector<unsigned> bases = primes(block);
  radical_inverses_scrambled(bases[dimension], 0, x, seed);
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of<permuted>, two_of<permuted>>("halton", kind);
}
}  // namespace mc::halton_by_digital_shift

// mistake: starts with point 1 of the sequence, not point 0
// hint: is it the sequence from index 0
namespace mc::halton_from_one {
void from_one(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables&) {
  static const std::vector<unsigned> bases = primes(block);
  if (dimension > 0) return radical_inverses_scrambled(bases[dimension], 1, x, seed);
  radical_inverses(2, 1, x);
  owen_scramble(x, seed);
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of<from_one>, two_of<from_one>>("halton", kind);
}
}  // namespace mc::halton_from_one

// mistake: starts again with dimension 0 after the eighth, without a permutation
// hint: every block but the first needs a shuffle
namespace mc::halton_goes_round {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_in_a_circle<fill_halton>, two_in_a_circle<fill_halton>>("halton",
                                                                                     kind);
}
}  // namespace mc::halton_goes_round

// mistake: uses the same permutation for all blocks but the first
// hint: each block needs a random permutation of its own
namespace mc::halton_padded_in_one_order {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_by<fill_halton, same_order>, two_by<fill_halton, same_order>>("halton",
                                                                                           kind);
}
}  // namespace mc::halton_padded_in_one_order

// mistake: permutes each column separately beyond the first eight dimensions
// hint: all dimensions of a block share one permutation
namespace mc::halton_shuffled_apart {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_by<fill_halton, own_order>, two_by<fill_halton, own_order>>("halton",
                                                                                         kind);
}
}  // namespace mc::halton_shuffled_apart

// mistake: uses 32 dimensions; beyond them, the first one or two again, shuffled
// hint: these are dimensions 8 to 15
// hint: high dimensions of a sequence are poor pairs
namespace mc::halton_without_blocks {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of_32<scrambled_halton>, two_of_32<scrambled_halton>>("halton", kind);
}
}  // namespace mc::halton_without_blocks

// mistake: gives a next2() the last dimension of a block and the first of the next
// hint: that is left out
namespace mc::last_dimension_and_first {
struct Wrong : ColumnSampler {
  using ColumnSampler::ColumnSampler;
  Point2 next2() override {
    if (next2_ == ready2_ && dimension_ % block == block - 1) {
      require_sample();
      if (ready2_ == twos_.size()) twos_.emplace_back();
      Pair& pair = twos_[ready2_++];
      pair.x.resize(samples_);
      pair.y.resize(samples_);
      const Use last{0, dimension_, order_, tables_};
      one_of<fill_sobol>(last, pair.x, rng_);
      order_ = Rng(rng_());
      const Use first{0, dimension_ + 1, order_, tables_};
      one_of<fill_sobol>(first, pair.y, rng_);
      dimension_ += 2;
    }
    return ColumnSampler::next2();
  }
};

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return kind == "sobol" ? make_spoiled<Wrong>(kind) : right_make_sampler(kind);
}
}  // namespace mc::last_dimension_and_first

// mistake: advances by one dimension in next2(), so its second axis is the next request's first
// hint: takes the next one of the sequence
namespace mc::next2_takes_one_dimension {
struct Wrong : ColumnSampler {
  using ColumnSampler::ColumnSampler;
  Point2 next2() override {
    if (next2_ != ready2_) return ColumnSampler::next2();
    const Point2 point = ColumnSampler::next2();
    --dimension_;
    return point;
  }
};

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return kind == "halton" ? make_spoiled<Wrong>(kind) : right_make_sampler(kind);
}
}  // namespace mc::next2_takes_one_dimension

// mistake: throws where the sequence has no more dimensions
// hint: dimension: there are only 32
namespace mc::no_more_than_32_dimensions {
void one(const Use& use, std::span<double> x, Rng& rng) {
  scrambled_sobol(use.dimension, x, rng);
}
void two(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  scrambled_sobol(use.dimension, x, rng);
  scrambled_sobol(use.dimension + 1, y, rng);
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one, two>("sobol", kind);
}
}  // namespace mc::no_more_than_32_dimensions

// mistake: counts next() and next2() together: a next() is half of a next2()
// hint: count the calls of next() and those of next2() in counters of their own
namespace mc::one_counter {
struct Wrong : ColumnSampler {
  using ColumnSampler::ColumnSampler;
  double next() override { return next2().x; }
};

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_spoiled<Wrong>(kind);
}
}  // namespace mc::one_counter

// mistake: scrambles both axes of a next2() with the same seed
// hint: one seed for several dimensions: each needs its own
namespace mc::one_scramble_for_both_axes {
void same_seed(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  Rng again = rng;
  fill_in_order<fill_sobol>(use, use.dimension, x, rng);
  fill_in_order<fill_sobol>(use, use.dimension + 1, y, again);
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of<fill_sobol>, same_seed>("sobol", kind);
}
}  // namespace mc::one_scramble_for_both_axes

// mistake: does not scramble the Sobol' sequence
// hint: a sequence as it is has the origin for its first point
namespace mc::sobol_as_it_is {
void plain(std::size_t dimension, std::span<double> x, std::uint64_t, Tables&) {
  sobol(static_cast<unsigned>(dimension), 0, x);
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of<plain>, two_of<plain>>("sobol", kind);
}
}  // namespace mc::sobol_as_it_is

// mistake: reuses the scrambles of the first block in every block, with other permutations
// hint: scrambled by seeds of its own
namespace mc::sobol_blocks_scrambled_alike {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return kind == "sobol" ? make_spoiled<BlocksAlike>(kind) : right_make_sampler(kind);
}
}  // namespace mc::sobol_blocks_scrambled_alike

// mistake: flips the same bits of all points of a dimension
// hint: owen_scramble of lab 5
namespace mc::sobol_by_digital_shift {
void shifted(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables&) {
  sobol(static_cast<unsigned>(dimension), 0, x);
  const std::uint64_t shift = seed >> 11;
  for (double& value : x) {
    value = static_cast<double>(static_cast<std::uint64_t>(value * 0x1p53) ^ shift) * 0x1p-53;
  }
}

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of<shifted>, two_of<shifted>>("sobol", kind);
}
}  // namespace mc::sobol_by_digital_shift

// mistake: starts again with dimension 0 after the eighth, without a permutation
// hint: every block but the first needs a shuffle
namespace mc::sobol_goes_round {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_in_a_circle<fill_sobol>, two_in_a_circle<fill_sobol>>("sobol", kind);
}
}  // namespace mc::sobol_goes_round

// mistake: uses the same permutation for all blocks but the first
// hint: each block needs a random permutation of its own
namespace mc::sobol_padded_in_one_order {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_by<fill_sobol, same_order>, two_by<fill_sobol, same_order>>("sobol",
                                                                                         kind);
}
}  // namespace mc::sobol_padded_in_one_order

// mistake: permutes each column separately beyond the first eight dimensions
// hint: all dimensions of a block share one permutation
namespace mc::sobol_shuffled_apart {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_by<fill_sobol, own_order>, two_by<fill_sobol, own_order>>("sobol",
                                                                                       kind);
}
}  // namespace mc::sobol_shuffled_apart

// mistake: uses 32 dimensions; beyond them, the first one or two again, shuffled
// hint: these are dimensions 8 to 15
// hint: high dimensions of a sequence are poor pairs
namespace mc::sobol_without_blocks {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return make_other_kind<one_of_32<scrambled_sobol>, two_of_32<scrambled_sobol>>("sobol", kind);
}
}  // namespace mc::sobol_without_blocks
