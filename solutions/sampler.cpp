// Lab 6 · the sampler: the reference solution. A sample dimension is a column of numbers, filled by
// a point set of labs 3 to 5 when it is first requested. The sampler then steps through its rows.

#include "sampler.hpp"
#include "common/choices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace mc {
namespace {

// 6.1 ---------------------------------------------------------------------------------------------

/// The first points of the Sobol' sequence in each dimension, not yet randomized (6.8).
using Tables = std::array<std::vector<double>, joe_kuo.size()>;

/// One sample dimension, or a pair, that is requested for the first time in this integration.
struct SampleDimension {
  std::size_t number;  ///< how many were requested before; next() and next2() are counted apart
  std::size_t place;   ///< in this round of a sequence, or that of the pair's first half (6.3)
  std::span<const unsigned> dimensions;  ///< by their place in a round; empty: 0, 1, …
  std::span<const double> order;         ///< of the points in this round; empty in the first
  Tables& tables;
};

/// The places of a sequence that this integration has taken (6.3).
struct Places {
  std::size_t round = 0, next = 0, half = 0;  ///< half: the unused half of a pair, or 0 (6.8)
};

/// How requests take the dimensions of a sequence (6.3): `take` returns the first of `count`
/// places, perhaps of another round; `order` makes the order of the points in that.
struct Sequence {
  std::span<const unsigned> dimensions;
  std::size_t (*take)(Places&, std::size_t count);
  std::vector<double> (*order)(std::size_t samples, Rng&);
};

/// A kind of sampler: `fill` fills the column of a next(), or both columns of a next2(); y is empty
/// for a next().
struct Kind {
  std::string_view name;
  void (*fill)(const SampleDimension&, std::span<double> x, std::span<double> y, Rng&);
  const Sequence* sequence = nullptr;
};

void independent(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  uniforms(rng, x);
  uniforms(rng, y);
}

// 6.2 ---------------------------------------------------------------------------------------------

/// 6.8  Puts points into random order, x and y together.
void shuffle_points(std::span<double> x, std::span<double> y, Rng& rng) {
  double *const xs = x.data(), *const ys = y.data();
  Choices any(rng);
  for (std::size_t n = x.size(); n > 1; --n) {
    const std::size_t last = any.below(n);
    std::swap(xs[n - 1], xs[last]);
    std::swap(ys[n - 1], ys[last]);
  }
}

void stratified(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  if (!y.empty()) {
    multi_jittered(x, y, strata(x.size()), rng);
    return shuffle_points(x, y, rng);
  }
  stratified_1d(x, rng);
  shuffle(x, rng);
}

// 6.3 ---------------------------------------------------------------------------------------------

/// Past the last dimension they start again at the first, with the points in another order, which
/// all columns of a round share. A next2() takes both dimensions from the same round.
std::size_t in_turn(Places& places, std::size_t count) {
  if (places.next + count > joe_kuo.size()) places = {places.round + 1};
  return std::exchange(places.next, places.next + count);
}

std::vector<double> random_order(std::size_t samples, Rng& rng) {
  std::vector<double> order(samples);
  std::iota(order.begin(), order.end(), 0.0);
  shuffle(order, rng);
  return order;
}

/// Writes to x, in the order of the round, the points that fill(column) writes in sequence.
template <class Fill>
void in_order(const SampleDimension& dim, std::span<double> x, Fill fill) {
  if (dim.order.empty()) return fill(x);
  std::vector<double> all(std::bit_ceil(x.size()));  // a nested order (6.8) needs more than N
  fill(std::span(all));
  std::transform(dim.order.begin(), dim.order.end(), x.begin(),
                 [&](double index) { return all[static_cast<std::size_t>(index)]; });
}

/// 6.8  A picture with few samples needs the same few points in every pixel, with new scrambling.
/// So short columns are stored before they are scrambled.
void sobol_points(unsigned dimension, std::span<double> x, Tables& tables) {
  constexpr std::size_t few = 4096;  // columns of this many samples stay in the cache
  std::vector<double>& kept = tables[dimension];
  if (x.size() > few) return sobol(dimension, 0, x);
  if (kept.size() < x.size()) {
    kept.resize(x.size());
    sobol(dimension, 0, kept);
  }
  std::copy_n(kept.begin(), x.size(), x.begin());
}

/// Fills x with the points in the dimension at `place`, randomized by `seed`.
using Randomized = void(const SampleDimension&, std::size_t place, std::span<double> x,
                        std::uint64_t seed);

void fill_sobol(const SampleDimension& dim, std::size_t place, std::span<double> x,
                std::uint64_t seed) {
  const auto dimension =
      dim.dimensions.empty() ? static_cast<unsigned>(place) : dim.dimensions[place];
  in_order(dim, x, [&](auto all) { sobol_points(dimension, all, dim.tables); });
  owen_scramble(x, seed);
}

/// In base 2, permuting a digit flips the bit in all points or in none, which is only a digital
/// shift. Nested scrambling (5.8) is better at the same cost, and the radical inverses in base 2
/// are dimension 0 of the Sobol' sequence.
void fill_halton(const SampleDimension& dim, std::size_t place, std::span<double> x,
                 std::uint64_t seed) {
  if (place == 0) return fill_sobol(dim, 0, x, seed);
  static const std::vector<unsigned> bases = primes(joe_kuo.size());
  in_order(dim, x, [&](auto all) { radical_inverses_scrambled(bases[place], 0, all, seed); });
}

template <Randomized fill>
void dimensions_of(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  fill(dim, dim.place, x, rng());
  if (!y.empty()) fill(dim, dim.place + 1, y, rng());
}

constexpr Sequence one_sequence{{}, in_turn, random_order};
[[maybe_unused]] constexpr Kind plain_kinds[] = {
    {"halton", dimensions_of<fill_halton>, &one_sequence},
    {"sobol", dimensions_of<fill_sobol>, &one_sequence}};

// 6.8  (`kinds` has these blocks instead) ---------------------------------------------------------

// Rounds of eight dimensions, in four pairs that leave no cell of a square grid of N cells empty at
// N = 4, 16, 64, 256 and 1024. Every next2() gets one of them, whatever calls of next() came
// before. docs/sampler-blocks.md has the other good pairs, the errors, and the price.
constexpr std::array<unsigned, 8> sobol_block{0, 1, 4, 6, 16, 20, 15, 21};

/// A next() takes half of the next pair, and the following next() the other half. A half that is
/// left over when the next round begins stays unused.
std::size_t in_pairs(Places& places, std::size_t count) {
  if (count == 1 && places.half > 0) return std::exchange(places.half, 0u);
  if (places.next == sobol_block.size()) places = {places.round + 1};
  const std::size_t first = std::exchange(places.next, places.next + 2);
  if (count == 1) places.half = first + 1;
  return first;
}

/// A nested shuffle (Burley 2020): the bits of a sample's number are scrambled as in 5.8. The first
/// 2^k samples get 2^k consecutive points, which are as good as the first 2^k.
std::vector<double> nested_order(std::size_t samples, Rng& rng) {
  const auto size = static_cast<double>(std::bit_ceil(samples));
  std::vector<double> order(samples);
  for (std::size_t i = 0; i < samples; ++i) order[i] = static_cast<double>(i) / size;
  owen_scramble(order, rng());
  for (double& index : order) index *= size;
  return order;
}

/// The radical inverse phi is dimension 0 of the Sobol' sequence. It has at most 32 bits, so its
/// products with z are exact. The vector's first pair is its worst at some N, so it is used last.
template <bool folds>
void fill_lattice(const SampleDimension& dim, std::size_t place, std::span<double> x,
                  std::uint64_t seed) {
  in_order(dim, x, [&](auto all) { sobol_points(0, all, dim.tables); });
  const auto z = static_cast<double>(lattice_vector[(place + 2) % 8]), shift = to_unit(Rng(seed)());
  for (double& value : x) {
    value *= z;
    value -= static_cast<double>(static_cast<int>(value));  // exact: the shift is not yet added
    value += shift;
    if (value >= 1) value -= 1;
    if (folds) value = std::min(1 - 0x1p-53, 2 * std::min(value, 1 - value));
  }
}

constexpr Sequence blocks{sobol_block, in_pairs, nested_order};

// 6.7 ---------------------------------------------------------------------------------------------

void blue_noise(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (y.empty() || dim.number > 0) return stratified(dim, x, y, rng);
  best_candidate(x, y, 1, rng);  // no shuffle: any first few of them are blue noise, too
}

constexpr Kind kinds[] = {{"independent", independent},
                          {"stratified", stratified},
                          {"blue_noise", blue_noise},
                          {"halton", dimensions_of<fill_halton>, &blocks},
                          {"sobol", dimensions_of<fill_sobol>, &blocks},
                          {"lattice", dimensions_of<fill_lattice<true>>, &blocks},
                          {"lattice_unfolded", dimensions_of<fill_lattice<false>>, &blocks}};

// 6.4 ---------------------------------------------------------------------------------------------

// 6.8  A number costs its virtual call, one comparison and two loads (by data(), since a vector may
// check every index). `ready_` is the number of columns, or 0 if there is no current sample: one
// comparison covers both. Rare work is in separate functions, so that next() saves no registers.

class ColumnSampler final : public Sampler {
 public:
  explicit ColumnSampler(const Kind& kind) : kind_(&kind) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0) throw std::invalid_argument("samples: must be positive");
    if (samples > most_samples) throw std::invalid_argument("samples: more than most_samples");
    samples_ = samples;
    rng_ = Rng(seed);
    sample_ = next_ = next2_ = ready_ = ready2_ = 0;
    places_ = {};
    order_.clear();
  }

  double next() override {
    if (next_ == ready_) return first_next();
    return ones_.data()[next_++].x.data()[sample_];
  }

  Point2 next2() override {
    if (next2_ == ready2_) return first_next2();
    const Columns& pair = twos_.data()[next2_++];
    return {pair.x.data()[sample_], pair.y.data()[sample_]};
  }

  void advance() override {
    next_ = next2_ = 0;
    if (sample_ < samples_ && ++sample_ == samples_) ready_ = ready2_ = 0;
  }

 private:
  struct Columns {
    std::vector<double> x, y;
  };

  // A single sample needs no columns, only their number: it requests each of its numbers once.
  [[gnu::noinline]] double first_next() {
    if (samples_ == 1 && sample_ == 0) return next_ = ++ready_, to_unit(rng_());
    make(ones_, ready_, 1);
    return next();
  }
  [[gnu::noinline]] Point2 first_next2() {
    if (samples_ == 1 && sample_ == 0)
      return next2_ = ++ready2_, Point2{to_unit(rng_()), to_unit(rng_())};
    make(twos_, ready2_, 2);
    return next2();
  }

  /// Fills the columns of a new sample dimension of `count` coordinates.
  void make(std::vector<Columns>& all, std::size_t& ready, std::size_t count) {
    require_sample();
    if (ready == all.size()) all.emplace_back();
    auto& [x, y] = all[ready];
    x.resize(samples_);
    if (count == 2) y.resize(samples_);
    kind_->fill(assign(count, ready), x, y, rng_);
    ++ready;
  }

  SampleDimension assign(std::size_t count, std::size_t number) {
    const Sequence* const sequence = kind_->sequence;
    if (sequence == nullptr) return {number, 0, {}, {}, tables_};
    const std::size_t round = places_.round, place = sequence->take(places_, count);
    if (places_.round != round) order_ = sequence->order(samples_, rng_);
    return {number, place, sequence->dimensions, order_, tables_};
  }

  void require_sample() const {
    if (sample_ >= samples_) throw std::out_of_range("no sample is left: call generate() first");
  }

  const Kind* kind_;
  Rng rng_{0};
  std::size_t samples_ = 0, sample_ = 0;  // their number, and the current one
  std::size_t next_ = 0, next2_ = 0;      // calls made by the current sample
  std::size_t ready_ = 0, ready2_ = 0;    // valid columns; 0 after the last sample
  Places places_;                         // of the sequence
  std::vector<double> order_;             // of the points in this round; empty in the first
  Tables tables_;
  std::vector<Columns> ones_, twos_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  std::string names;
  for (const Kind& known : kinds) {
    if (known.name == kind) return std::make_unique<ColumnSampler>(known);
    names += ' ' + std::string(known.name);
  }
  throw std::invalid_argument("kind: '" + std::string(kind) + "' is unknown; known kinds:" + names);
}

// 6.5 ---------------------------------------------------------------------------------------------

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  double sum = 0;
  for (std::size_t i = 0; i < samples; ++i, sampler.advance()) sum += scene.sample(sampler);
  return sum / static_cast<double>(samples);
}

// 6.6 ---------------------------------------------------------------------------------------------

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: must be positive");
  if (scene.width > 0 && scene.height > most_samples / scene.width) {
    throw std::invalid_argument("scene: more than most_samples pixels");
  }
  Image image{scene.width, scene.height, {}};
  Rng seeds(seed);
  for (std::size_t row = 0; row < scene.height; ++row) {
    for (std::size_t column = 0; column < scene.width; ++column) {
      const Scene pixel{scene.uses, [&](Sampler& s) { return scene.sample(column, row, s); }};
      image.pixels.push_back(integrate(pixel, sampler, spp, seeds()));
    }
  }
  return image;
}

}  // namespace mc
