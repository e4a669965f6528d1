// Lab 6 · the sampler: the reference solution. It stands on the point sets of labs 3 to 5, which
// fill columns; what is left to do is to make a column when a scene first asks for it, and to walk
// along the samples.

#include "sampler.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace mc {
namespace {

// 6.1 ---------------------------------------------------------------------------------------------

/// The first points of a sequence's dimensions, not randomised yet (6.3).
using Tables = std::array<std::vector<double>, 8>;

/// A sample dimension, or two, asked for the first time in this integration.
struct Use {
  std::size_t number;     ///< how many of its sort were before it, next() and next2() counted apart
  std::size_t dimension;  ///< of a sequence: the one that it gets, or the first of two (6.3)
  const Rng& order;       ///< for the random order of the block of dimensions they belong to (6.3)
  Tables& tables;
};

/// What tells one kind from another: how the column of a next() is filled, or the two of a next2().
struct Kind {
  std::string_view name;
  void (*one)(const Use&, std::span<double> x, Rng&);
  void (*two)(const Use&, std::span<double> x, std::span<double> y, Rng&);
};

void independent1(const Use&, std::span<double> x, Rng& rng) {
  uniforms(rng, x);
}
void independent2(const Use&, std::span<double> x, std::span<double> y, Rng& rng) {
  uniforms(rng, x);
  uniforms(rng, y);
}

// 6.2 ---------------------------------------------------------------------------------------------

constexpr std::size_t few = 4096;  // samples whose columns stay in a cache

void stratified1(const Use&, std::span<double> x, Rng& rng) {
  stratified_1d(x, rng);
  shuffle(x, rng);
}

/// 6.8 Puts points into random order, x and y together. Of few points a random word chooses several
/// (as in 3.4), which move both coordinates. Many points are swapped column by column.
void shuffle_points(std::span<double> x, std::span<double> y, Rng& rng) {
  if (x.size() > few) {
    Rng again = rng;
    shuffle(x, rng);
    shuffle(y, again);  // the same numbers, so the same order: pairs stay together
    return;
  }
  double *const xs = x.data(), *const ys = y.data();
  constexpr std::uint64_t most_used = 1 << 24;  // of a word: what its choices multiply to
  std::uint64_t word = 0, used = most_used;
  for (std::size_t n = x.size(); n > 1; --n) {
    used *= n;
    if (used > most_used) word = rng(), used = n;
    const auto product = static_cast<unsigned __int128>(word) * n;
    const auto any = static_cast<std::size_t>(product >> 64);  // one of the first n
    word = static_cast<std::uint64_t>(product);
    std::swap(xs[n - 1], xs[any]);
    std::swap(ys[n - 1], ys[any]);
  }
}

void stratified2(const Use&, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
  shuffle_points(x, y, rng);
}

// 6.3 ---------------------------------------------------------------------------------------------

// Sample dimensions take dimension after dimension of a sequence, but of its first eight only: they
// are the best, in Halton's sequence since their primes are small, in Sobol's since any two of them
// fill the plane with few points. Whoever asks for more gets the same eight again, scrambled anew
// and in another order of the points, so that a block has nothing to do with the one before it. The
// columns of a block share their order: it is what holds them together.

constexpr std::size_t block = std::tuple_size_v<Tables>;

/// Writes a dimension's points, randomised by `seed`.
using Randomised = void(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables&);

// 6.8 A picture asks for the same few points in every pixel, and then for other scrambles of them:
// so short columns are kept as they are before they are scrambled.
template <auto fill>
void fill_or_copy(std::size_t dimension, std::span<double> x, Tables& tables) {
  std::vector<double>& kept = tables[dimension];
  if (x.size() > few) return fill(dimension, x);
  if (kept.size() < x.size()) {
    kept.resize(x.size());
    fill(dimension, kept);
  }
  std::copy_n(kept.begin(), x.size(), x.begin());
}

void sobol_points(std::size_t dimension, std::span<double> x) {
  sobol(static_cast<unsigned>(dimension), 0, x);
}
void fill_sobol(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables& tables) {
  fill_or_copy<sobol_points>(dimension, x, tables);
  owen_scramble(x, seed);
}

/// In base 2 a permutation of a digit flips a bit or does not, for all points alike: no more than a
/// digital shift. Nested scrambling is to be had at the same price (5.8), and the radical inverses
/// in base 2 are Sobol's dimension 0.
void fill_halton(std::size_t dimension, std::span<double> x, std::uint64_t seed, Tables& tables) {
  if (dimension == 0) return fill_sobol(0, x, seed, tables);
  static const std::vector<unsigned> bases = primes(block);
  radical_inverses_scrambled(bases[dimension], 0, x, seed);
}

template <Randomised fill>
void fill_in_order(const Use& use, std::size_t dimension, std::span<double> x, Rng& rng) {
  fill(dimension % block, x, rng(), use.tables);
  if (dimension < block) return;
  Rng order = use.order;  // a copy: the same numbers for the whole block
  shuffle(x, order);
}
template <Randomised fill>
void one_of(const Use& use, std::span<double> x, Rng& rng) {
  fill_in_order<fill>(use, use.dimension, x, rng);
}
template <Randomised fill>
void two_of(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  fill_in_order<fill>(use, use.dimension, x, rng);
  fill_in_order<fill>(use, use.dimension + 1, y, rng);
}

// 6.7 ---------------------------------------------------------------------------------------------

void blue_noise2(const Use& use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.number > 0) return stratified2(use, x, y, rng);
  best_candidate(x, y, 1, rng);  // any first few of them are blue noise too: no shuffle
}

constexpr Kind kinds[] = {{"independent", independent1, independent2},
                          {"stratified", stratified1, stratified2},
                          {"blue_noise", stratified1, blue_noise2},
                          {"halton", one_of<fill_halton>, two_of<fill_halton>},
                          {"sobol", one_of<fill_sobol>, two_of<fill_sobol>}};

// 6.4 ---------------------------------------------------------------------------------------------

// 6.8 What a number costs: a column is made whole when its use is first asked for, by the
// vectorised loops of labs 2 to 5. After that a number costs its virtual call, one comparison and
// two loads, by data(), since an index of a vector may be checked each time: `ready_` says how many
// uses there are columns for, and that it is none where there is no sample, so that both questions
// are one. What happens rarely stands in functions of its own, or the compiler would have next()
// save registers for it in every call. Columns keep their memory from one integration to the next:
// a picture has one for each pixel.

class ColumnSampler final : public Sampler {
 public:
  explicit ColumnSampler(const Kind& kind) : kind_(kind) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0) throw std::invalid_argument("samples: there are none");
    if (samples > most_samples) throw std::invalid_argument("samples: more than memory may hold");
    samples_ = samples;
    rng_ = Rng(seed);
    sample_ = next_ = next2_ = ready_ = ready2_ = dimension_ = 0;
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
    kind_.one(taking(1, ready_), ones_[ready_], rng_);
    ++ready_;
    return next();
  }

  [[gnu::noinline]] Point2 first_next2() {
    require_sample();
    if (ready2_ == twos_.size()) twos_.emplace_back();
    Pair& pair = twos_[ready2_];
    pair.x.resize(samples_);
    pair.y.resize(samples_);
    kind_.two(taking(2, ready2_), pair.x, pair.y, rng_);
    ++ready2_;
    return next2();
  }

  /// The use that takes the next one or two dimensions. Two come from one block: where it has only
  /// one left, that is left over.
  Use taking(std::size_t count, std::size_t number) {
    if (dimension_ % block + count > block) ++dimension_;
    if (dimension_ > 0 && dimension_ % block == 0) order_ = Rng(rng_());
    dimension_ += count;
    return {number, dimension_ - count, order_, tables_};
  }

  void require_sample() const {
    if (sample_ < samples_) return;
    throw std::out_of_range(samples_ == 0 ? "no samples yet: generate() comes first"
                                          : "all samples are done: generate() makes new ones");
  }

  const Kind& kind_;
  Rng rng_{0};
  std::size_t samples_ = 0, sample_ = 0;  // how many there are, and which this is
  std::size_t next_ = 0, next2_ = 0;      // uses that this sample has asked for
  std::size_t ready_ = 0, ready2_ = 0;    // uses that have columns; none after the last sample
  std::size_t dimension_ = 0;             // of a sequence: the next one
  Rng order_{0};                          // of its block
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
  throw std::invalid_argument("kind: there is no '" + std::string(kind) + "', only" + names);
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
  if (spp == 0) throw std::invalid_argument("spp: no samples for a pixel");
  if (scene.width > 0 && scene.height > most_samples / scene.width) {
    throw std::invalid_argument("scene: more pixels than memory may hold");
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
