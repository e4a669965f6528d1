// Lab 6 · the sampler: the reference solution. It stands on the point sets of labs 3 to 5, which
// fill columns; what is left to do is to make a column when a scene first asks for it, and to walk
// along the samples.

#include "sampler.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace mc {
namespace {

// 6.1 ---------------------------------------------------------------------------------------------

/// A use that is asked for the first time: how many of its sort were before it in this integration,
/// next() and next2() counted apart, and how many dimensions all of them have taken.
struct Use {
  std::size_t number, dimensions_before;
};

/// What tells one kind from another: how the column of a use, or its two, are filled.
struct Kind {
  std::string_view name;
  void (*one)(Use, std::span<double> x, Rng&);
  void (*two)(Use, std::span<double> x, std::span<double> y, Rng&);
};

void independent1(Use, std::span<double> x, Rng& rng) {
  uniforms(rng, x);
}
void independent2(Use, std::span<double> x, std::span<double> y, Rng& rng) {
  uniforms(rng, x);
  uniforms(rng, y);
}

// 6.2 ---------------------------------------------------------------------------------------------

/// Both columns in the same random order, so that pairs stay together: 3.4 for two at once.
void shuffle_pairs(std::span<double> x, std::span<double> y, Rng& rng) {
  std::array<double, 256> any;
  for (std::size_t n = x.size(); n > 1;) {
    const auto block = std::span(any).first(std::min(any.size(), n - 1));
    uniforms(rng, block);
    for (const double u : block) {
      const auto last = static_cast<std::int64_t>(u * static_cast<double>(n--));
      std::swap(x[n], x[static_cast<std::size_t>(last)]);
      std::swap(y[n], y[static_cast<std::size_t>(last)]);
    }
  }
}

void stratified1(Use, std::span<double> x, Rng& rng) {
  stratified_1d(x, rng);
  shuffle(x, rng);
}
void stratified2(Use, std::span<double> x, std::span<double> y, Rng& rng) {
  multi_jittered(x, y, strata(x.size()), rng);
  shuffle_pairs(x, y, rng);
}

// 6.3 ---------------------------------------------------------------------------------------------

// Uses take dimension after dimension of a sequence. Where there are no more, they are padded with
// its first ones, in an order of their own. So is Halton's from the 33rd dimension on, the prime
// 137: with fewer samples than that, a column would be random numbers at a high price.

constexpr std::size_t dimensions = joe_kuo.size();

using Randomised = void(std::size_t dimension, std::span<double> x, Rng& rng);

void fill_halton(std::size_t dimension, std::span<double> x, Rng& rng) {
  static const std::vector<unsigned> bases = primes(dimensions);
  radical_inverses_scrambled(bases[dimension], 0, x, rng());
}
void fill_sobol(std::size_t dimension, std::span<double> x, Rng& rng) {
  sobol(static_cast<unsigned>(dimension), 0, x);
  owen_scramble(x, rng());
}

template <Randomised fill>
void one_of(Use use, std::span<double> x, Rng& rng) {
  if (use.dimensions_before < dimensions) return fill(use.dimensions_before, x, rng);
  fill(0, x, rng);
  shuffle(x, rng);
}
template <Randomised fill>
void two_of(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  const bool padded = use.dimensions_before + 2 > dimensions;
  const std::size_t first = padded ? 0 : use.dimensions_before;
  fill(first, x, rng);
  fill(first + 1, y, rng);
  if (padded) shuffle_pairs(x, y, rng);
}

// 6.7 ---------------------------------------------------------------------------------------------

void blue_noise2(Use use, std::span<double> x, std::span<double> y, Rng& rng) {
  if (use.number > 0) return stratified2(use, x, y, rng);
  best_candidate(x, y, 1, rng);  // any first few of them are blue noise too: no shuffle
}

constexpr Kind kinds[] = {{"independent", independent1, independent2},
                          {"stratified", stratified1, stratified2},
                          {"blue_noise", stratified1, blue_noise2},
                          {"halton", one_of<fill_halton>, two_of<fill_halton>},
                          {"sobol", one_of<fill_sobol>, two_of<fill_sobol>}};

// 6.4 ---------------------------------------------------------------------------------------------

// 6.8 What a number costs: a column is made whole when its use is first asked for, by the vectorised
// loops of labs 2 to 5. After that a number costs its virtual call, one comparison and two loads:
// `ready_` says how many uses there are columns for, and that it is none where there is no sample, so
// that both questions are one. What happens rarely stands in functions of its own, or the compiler
// would have next() save registers for it in every call. Columns keep their memory from one
// integration to the next: a picture has one for each pixel.

class ColumnSampler final : public Sampler {
 public:
  explicit ColumnSampler(const Kind& kind) : kind_(kind) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0) throw std::invalid_argument("samples: there are none");
    if (samples > most_samples) throw std::invalid_argument("samples: more than memory may hold");
    samples_ = samples;
    rng_ = Rng(seed);
    sample_ = next_ = next2_ = ready_ = ready2_ = 0;
  }

  double next() override {
    if (next_ == ready_) return first_next();
    return ones_[next_++][sample_];
  }

  Point2 next2() override {
    if (next2_ == ready2_) return first_next2();
    const Pair& pair = twos_[next2_++];
    return {pair.x[sample_], pair.y[sample_]};
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
    kind_.one({ready_, ready_ + 2 * ready2_}, ones_[ready_], rng_);
    ++ready_;
    return next();
  }

  [[gnu::noinline]] Point2 first_next2() {
    require_sample();
    if (ready2_ == twos_.size()) twos_.emplace_back();
    Pair& pair = twos_[ready2_];
    pair.x.resize(samples_);
    pair.y.resize(samples_);
    kind_.two({ready2_, ready_ + 2 * ready2_}, pair.x, pair.y, rng_);
    ++ready2_;
    return next2();
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
