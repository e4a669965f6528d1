// Lab 6 · the sampler: the reference solution. A sample dimension is a column of numbers, filled by
// a point set of labs 3 to 5 when it is first requested. The sampler then steps through its rows.

#include "sampler.hpp"
#include "common/choices.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <stdexcept>
#include <string>
#include <vector>

namespace mc {
namespace {

// 6.1 ---------------------------------------------------------------------------------------------

/// The first points of a sequence in each of eight dimensions, not yet randomized (6.3).
using Tables = std::array<std::vector<double>, 8>;

/// One sample dimension, or a pair, that is requested for the first time in this integration.
struct SampleDimension {
  /// How many were requested before, with next() and next2() counted separately.
  std::size_t number;
  /// Its dimension of the sequence, or the first of the pair, counted over all blocks (6.3).
  std::size_t of_sequence;
  /// The order of the points in its block; empty for the first block (6.3).
  std::span<const std::uint32_t> order;
  Tables& tables;
};

/// A kind of sampler: a function that fills the column of a next(), and one for the pair of columns
/// of a next2().
struct Kind {
  std::string_view name;
  void (*one)(const SampleDimension&, std::span<double> x, Rng&);
  void (*two)(const SampleDimension&, std::span<double> x, std::span<double> y, Rng&);
};

void independent1(const SampleDimension&, std::span<double> x, Rng& rng) {
  uniforms(rng, x);
}
void independent2(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  uniforms(rng, x);
  uniforms(rng, y);
}

// 6.2 ---------------------------------------------------------------------------------------------

constexpr std::size_t few = 4096;  // columns of this many samples stay in the cache

void stratified1(const SampleDimension&, std::span<double> x, Rng& rng) {
  stratified_1d(x, rng);
  shuffle(x, rng);
}

/// 6.8  Puts points into random order, x and y together. Columns that do not fit into the cache are
/// shuffled one after the other, which is faster there.
void shuffle_points(std::span<double> x, std::span<double> y, Rng& rng) {
  if (x.size() > few) {
    Rng again = rng;
    shuffle(x, rng);
    shuffle(y, again);  // the same random numbers, so the same order
    return;
  }
  double *const xs = x.data(), *const ys = y.data();
  Choices any(rng);
  for (std::size_t n = x.size(); n > 1; --n) {
    const std::size_t last = any.below(n);
    std::swap(xs[n - 1], xs[last]);
    std::swap(ys[n - 1], ys[last]);
  }
}

void stratified2(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
  shuffle_points(x, y, rng);
}

// 6.3 ---------------------------------------------------------------------------------------------

// Nested scrambling maps elementary intervals to elementary intervals: it cannot fill cells that a
// pair of dimensions leaves empty. The first 16 points of Sobol' dimensions 6 and 7 leave 12 of 16
// cells empty. Among all pairs of the 32 dimensions, eight leave no cell of a square grid of N
// cells empty at N = 4, 16, 64, 256 and 1024: (0,1), (0,12), (0,13), (4,6), (7,13), (10,20),
// (15,21), (16,20). A block consists of four of these pairs, and every next2() gets one of them,
// whatever calls of next() came before. If each call took the next single dimension instead, a
// next() would shift all later pairs, and there is no order of eight dimensions in which all
// neighbors are good pairs (at most four).
//
// Mean squared errors relative to independent samples, for exp(x + y + ...) (./lab bench sampler
// --tables) and, for pairs, also for a half-plane:
//
//                                       N = 16      64       256      1024
//   0 1 2 3 4 5 6 7      worst pair       1.1e-1   1.2e-3   1.6e-3   1.1e-5
//                        half-plane       1.1      1.3e-1   1.9e-1   3.2e-2
//                        first four       4.4e-2   3.6e-3   1.2e-3   5.3e-5
//                        all eight        2.7e-1   7.1e-2   1.4e-2   3.5e-3
//   0 1 4 6 16 20 15 21  worst pair       1.2e-2   3.4e-3   1.6e-3   1.6e-5
//                        half-plane       2.5e-1   1.3e-1   6.4e-2   3.2e-2
//                        first four       1.9e-1   6.1e-3   2.0e-3   1.2e-4
//                        all eight        4.9e-1   9.2e-2   3.2e-2   2.7e-2
//
// So integrands that are smooth in four or eight dimensions lose accuracy. But most pixels have
// edges in pairs of dimensions and few samples, and there even the worst pair is now better than
// independent samples. Among the orders that begin with (0,1), (4,6), this is one of the two best
// in four and eight dimensions, by the logarithms of such ratios.

/// The Halton sequence needs no such choice: its digits are permuted, and it takes the first
/// primes.
constexpr std::array<unsigned, 8> sobol_block{0, 1, 4, 6, 16, 20, 15, 21};
constexpr std::size_t block = sobol_block.size();

// Later blocks use the same eight dimensions with new scrambling and with the points in another
// order, so that the blocks are independent of each other. The columns of one block share the
// order, so that its points stay together. The order is a nested shuffle (Burley 2020): the first
// 2^k samples get 2^k consecutive points, which are as well distributed as the first 2^k.

/// Nested scrambling of the numbers 0, 1, … samples - 1, with their bits placed after the point:
/// each bit is flipped depending on the bits before it.
std::vector<std::uint32_t> nested_order(std::size_t samples, std::uint64_t seed) {
  const auto size = static_cast<double>(std::bit_ceil(samples));
  std::vector<double> index(samples);
  for (std::size_t i = 0; i < samples; ++i) index[i] = static_cast<double>(i) / size;
  owen_scramble(index, seed);
  std::vector<std::uint32_t> order(samples);
  std::transform(index.begin(), index.end(), order.begin(),
                 [=](double i) { return static_cast<std::uint32_t>(i * size); });
  return order;
}

/// Writes the points 0, 1, … to x in the order of the block. `fill(column)` writes them in
/// sequence.
template <class Fill>
void in_order(const SampleDimension& dim, std::span<double> x, Fill fill) {
  if (dim.order.empty()) return fill(x);
  std::vector<double> all(std::bit_ceil(x.size()));
  fill(std::span(all));
  std::transform(dim.order.begin(), dim.order.end(), x.begin(),
                 [&](std::uint32_t index) { return all[index]; });
}

// 6.8  A picture with few samples needs the same few points in every pixel, with new scrambling. So
// short columns are stored before they are scrambled.
void sobol_points(std::size_t place, std::span<double> x, Tables& tables) {
  std::vector<double>& kept = tables[place];
  if (x.size() > few) return sobol(sobol_block[place], 0, x);
  if (kept.size() < x.size()) {
    kept.resize(x.size());
    sobol(sobol_block[place], 0, kept);
  }
  std::copy_n(kept.begin(), x.size(), x.begin());
}

/// Fills x with the points in dimension `place` of the block, randomized by `seed`.
using Randomized = void(const SampleDimension&, std::size_t place, std::span<double> x,
                        std::uint64_t seed);

void fill_sobol(const SampleDimension& dim, std::size_t place, std::span<double> x,
                std::uint64_t seed) {
  in_order(dim, x, [&](std::span<double> all) { sobol_points(place, all, dim.tables); });
  owen_scramble(x, seed);
}

/// In base 2, permuting a digit flips the bit in all points or in none, which is only a digital
/// shift. Nested scrambling (5.8) is better at the same cost, and the radical inverses in base 2
/// are dimension 0 of the Sobol' sequence.
void fill_halton(const SampleDimension& dim, std::size_t place, std::span<double> x,
                 std::uint64_t seed) {
  if (place == 0) return fill_sobol(dim, 0, x, seed);
  constexpr unsigned bases[block] = {2, 3, 5, 7, 11, 13, 17, 19};
  in_order(dim, x,
           [&](std::span<double> all) { radical_inverses_scrambled(bases[place], 0, all, seed); });
}

/// The radical inverse phi is dimension 0 of the Sobol' sequence. It has at most 32 bits, so its
/// products with z are exact.
void fill_lattice(const SampleDimension& dim, std::size_t place, std::span<double> x,
                  std::uint64_t seed) {
  in_order(dim, x, [&](std::span<double> all) { sobol_points(0, all, dim.tables); });
  const auto z = static_cast<double>(lattice_vector[place]), shift = to_unit(Rng(seed)());
  for (double& value : x) {
    value *= z;
    value -=
        static_cast<double>(static_cast<int>(value));  // exact, because the shift is not yet added
    value += shift;
    if (value >= 1) value -= 1;
    value = std::min(1 - 0x1p-53, 2 * std::min(value, 1 - value));
  }
}

template <Randomized fill>
void one_of(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  fill(dim, dim.of_sequence % block, x, rng());
}
template <Randomized fill>
void two_of(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  fill(dim, dim.of_sequence % block, x, rng());
  fill(dim, dim.of_sequence % block + 1, y, rng());
}

// 6.7 ---------------------------------------------------------------------------------------------

void blue_noise2(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  if (dim.number > 0) return stratified2(dim, x, y, rng);
  best_candidate(x, y, 1, rng);  // no shuffle: any first few of them are blue noise, too
}

constexpr Kind kinds[] = {{"independent", independent1, independent2},
                          {"stratified", stratified1, stratified2},
                          {"blue_noise", stratified1, blue_noise2},
                          {"halton", one_of<fill_halton>, two_of<fill_halton>},
                          {"sobol", one_of<fill_sobol>, two_of<fill_sobol>},
                          {"lattice", one_of<fill_lattice>, two_of<fill_lattice>}};

// 6.4 ---------------------------------------------------------------------------------------------

// 6.8  The cost of a number: when a sample dimension is first requested, the vectorized loops of
// labs 2 to 5 fill the whole column. After that, a number costs its virtual call, one comparison
// and two loads (by data(), since a vector may check every index). `ready_` is the number of
// columns, or 0 if there is no current sample, so that one comparison covers both cases. Rare work
// is in separate functions: otherwise the compiler would save registers for it in every next().
// Columns keep their memory from one integration to the next, since a picture has one integration
// per pixel.

class ColumnSampler final : public Sampler {
 public:
  explicit ColumnSampler(const Kind& kind) : requested_kind_(kind) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0) throw std::invalid_argument("samples: must be positive");
    if (samples > most_samples) throw std::invalid_argument("samples: more than most_samples");
    kind_ = samples == 1 ? &kinds[0] : &requested_kind_;  // one sample is just uniform
    samples_ = samples;
    rng_ = Rng(seed);
    sample_ = next_ = next2_ = ready_ = ready2_ = dimension_ = half_ = 0;
    order_.clear();
  }

  double next() override {
    if (next_ == ready_) return first_next();
    return ones_.data()[next_++].data()[sample_];
  }

  Point2 next2() override {
    if (next2_ == ready2_) return first_next2();
    const Pair& pair = twos_.data()[next2_++];
    return {pair.x.data()[sample_], pair.y.data()[sample_]};
  }

  void advance() override {
    next_ = next2_ = 0;
    if (sample_ < samples_ && ++sample_ == samples_) ready_ = ready2_ = 0;
  }

 private:
  struct Pair {
    std::vector<double> x, y;
  };

  [[gnu::noinline]] double first_next() {
    require_sample();
    if (ready_ == ones_.size()) ones_.emplace_back();
    ones_[ready_].resize(samples_);
    kind_->one(assign(1, ready_), ones_[ready_], rng_);
    ++ready_;
    return next();
  }

  [[gnu::noinline]] Point2 first_next2() {
    require_sample();
    if (ready2_ == twos_.size()) twos_.emplace_back();
    Pair& pair = twos_[ready2_];
    pair.x.resize(samples_);
    pair.y.resize(samples_);
    kind_->two(assign(2, ready2_), pair.x, pair.y, rng_);
    ++ready2_;
    return next2();
  }

  /// Assigns the next pair of the sequence, or half of a pair if `count` is 1, to a sample
  /// dimension. After the last pair of a block a new block begins; an unused half is then dropped.
  SampleDimension assign(std::size_t count, std::size_t number) {
    std::size_t dimension = half_;
    if (count == 1 && half_ > 0) {
      half_ = 0;
    } else {
      if (dimension_ > 0 && dimension_ % block == 0) {
        half_ = 0;
        order_ = nested_order(samples_, rng_());
      }
      dimension = dimension_;
      if (count == 1) half_ = dimension + 1;
      dimension_ += 2;
    }
    return {number, dimension, order_, tables_};
  }

  void require_sample() const {
    if (sample_ < samples_) return;
    throw std::out_of_range(samples_ == 0 ? "no samples yet: call generate() first"
                                          : "no samples left: call generate() for new ones");
  }

  const Kind& requested_kind_;
  const Kind* kind_ = nullptr;  // requested_kind_, or independent for one sample
  Rng rng_{0};
  std::size_t samples_ = 0, sample_ = 0;  // their number, and the current one
  std::size_t next_ = 0, next2_ = 0;      // calls made by the current sample
  std::size_t ready_ = 0, ready2_ = 0;    // valid columns; 0 after the last sample
  std::size_t dimension_ = 0;             // first dimension of the sequence's next pair
  std::size_t half_ = 0;                  // the unused half of a pair, or 0
  std::vector<std::uint32_t> order_;      // of the points in this block; empty in the first
  Tables tables_;
  std::vector<std::vector<double>> ones_;
  std::vector<Pair> twos_;
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
  image.pixels.reserve(scene.width * scene.height);
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
