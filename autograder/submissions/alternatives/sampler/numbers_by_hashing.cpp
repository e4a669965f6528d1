// alternative: stateless: every number is computed when it is asked for, from the seed, the use and
// the number of the sample; stratified points by a hashed permutation and correlated multi-jitter

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>

#include "sampler.hpp"

namespace mc {
namespace {

std::uint64_t hash(std::uint64_t a, std::uint64_t b) {
  return mix_bits(mix_bits(a) + b * 0x9e3779b97f4a7c15u);
}

/// The i-th element of a random permutation of `size`: a bijection of the next power of two, taken
/// again as long as it leads out (cycle walking). Odd factors, sums, and whatever is added to the
/// upper half by the lower one's leave keep it a bijection.
std::size_t permuted(std::size_t i, std::size_t size, std::uint64_t seed) {
  std::uint64_t mask = 1;
  while (mask + 1 < size) mask = 2 * mask + 1;
  int bits = 0;
  while (mask >> bits != 0) ++bits;
  const int half = (bits + 1) / 2;
  std::uint64_t at = i;
  do {
    for (unsigned round = 0; round < 6; ++round) {
      const std::uint64_t key = hash(seed, round);
      at = (at * (key | 1) + (key >> 32)) & mask;
      at ^= at >> half;
      const std::uint64_t lower = at & ((std::uint64_t{1} << half) - 1);
      at = (at + (hash(key, lower) << half)) & mask;
    }
  } while (at >= size);
  return at;
}

/// Point `u` of stratum i of n, below its upper edge.
double place(std::size_t i, std::size_t n, double u) {
  const auto size = static_cast<double>(n);
  const double low = static_cast<double>(i) / size, high = static_cast<double>(i + 1) / size;
  return std::max(low, std::min((static_cast<double>(i) + u) / size, std::nextafter(high, 0.0)));
}

enum class Pattern { independent, stratified, halton, sobol, blue_noise };

class HashedSampler final : public Sampler {
 public:
  explicit HashedSampler(Pattern pattern) : pattern_(pattern) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0 || samples > most_samples) {
      throw std::invalid_argument("samples: 1 to " + std::to_string(most_samples));
    }
    samples_ = samples;
    seed_ = hash(seed, 0x5eed);
    sample_ = next_ = next2_ = 0;
    first_.clear();
    dimensions_ = 0;
    has_half_ = false;
    blue_ = PointSet();
  }

  double next() override {
    require();
    const std::uint64_t use = 2 * next_++;
    const std::uint64_t key = hash(seed_, use);
    if (is_sequence()) return coordinate(dimension(use, 1), key);
    if (pattern_ == Pattern::independent) return number(key);
    return place(permuted(sample_, samples_, hash(key, 1)), samples_, number(key));
  }

  Point2 next2() override {
    require();
    const std::uint64_t use = 2 * next2_++ + 1;
    const std::uint64_t key = hash(seed_, use), other = hash(key, 77);
    if (is_sequence()) {
      const std::size_t d = dimension(use, 2);
      return {coordinate(d, key), coordinate(d + 1, hash(key, 2))};
    }
    if (pattern_ == Pattern::independent) return {number(key), number(other)};
    if (pattern_ == Pattern::blue_noise && use == 1) return blue(key);
    const Grid grid = strata(samples_);
    const std::size_t cell = permuted(sample_, samples_, hash(key, 1));
    const std::size_t i = cell % grid.nx, j = cell / grid.nx;
    return {place(i * grid.ny + permuted(j, grid.ny, hash(key, 2)), samples_, number(key)),
            place(j * grid.nx + permuted(i, grid.nx, hash(key, 3)), samples_, number(other))};
  }

  void advance() override {
    next_ = next2_ = 0;
    if (sample_ < samples_) ++sample_;
  }

 private:
  bool is_sequence() const { return pattern_ == Pattern::halton || pattern_ == Pattern::sobol; }
  void require() const {
    if (sample_ >= samples_) throw std::out_of_range("there is no such sample");
  }
  double number(std::uint64_t key) const { return to_unit(hash(key, sample_)); }

  /// The dimension that a use was given when it was first asked for: of 8, 8, 8, …
  std::size_t dimension(std::uint64_t use, std::size_t takes) {
    const auto [known, is_new] = first_.insert({use, 0});
    if (!is_new) return known->second;
    if (takes == 1 && has_half_) {
      has_half_ = false;
      return known->second = half_;
    }
    known->second = dimensions_;
    if (dimensions_ % 8 == 0) has_half_ = false;
    dimensions_ += 2;
    if (takes == 1) {
      has_half_ = true;
      half_ = known->second + 1;
    }
    return known->second;
  }

  /// The sample's point in a later block: each bit is flipped by a hash of those above it.
  std::size_t nested(std::uint64_t key) const {
    std::size_t index = sample_;
    for (unsigned bit = 0; samples_ > std::size_t{1} << bit; ++bit) {
      index ^= hash(hash(key, bit), sample_ >> (bit + 1)) >> 63 << bit;
    }
    return index;
  }

  double coordinate(std::size_t d, std::uint64_t key) const {
    const std::size_t number = d / 8, which = d % 8;
    const std::uint64_t order = hash(hash(seed_, 0x0bde), number);
    const std::size_t index = number == 0 ? sample_ : nested(order);
    double x = 0;
    const auto column = std::span(&x, 1);
    if (pattern_ == Pattern::halton && which > 0) {
      constexpr unsigned bases[] = {2, 3, 5, 7, 11, 13, 17, 19};
      radical_inverses_scrambled(bases[which], index, column, key);
    } else {  // dimension 0 of both is van der Corput's
      constexpr unsigned dimensions[] = {0, 1, 4, 6, 16, 20, 15, 21};
      sobol(dimensions[which], index, column);
      owen_scramble(column, key);
    }
    return x;
  }

  /// Blue noise has no formula: the one thing that is stored.
  Point2 blue(std::uint64_t key) {
    if (blue_.size() == 0) {
      blue_ = PointSet(samples_, 2);
      Rng rng(key);
      best_candidate(blue_.column(0), blue_.column(1), 1, rng);
    }
    return {blue_.column(0)[sample_], blue_.column(1)[sample_]};
  }

  Pattern pattern_;
  std::uint64_t seed_ = 0;
  std::size_t samples_ = 0, sample_ = 0, next_ = 0, next2_ = 0, dimensions_ = 0, half_ = 0;
  bool has_half_ = false;
  std::map<std::uint64_t, std::size_t> first_;
  PointSet blue_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  static const std::map<std::string_view, Pattern> patterns{{"independent", Pattern::independent},
                                                            {"stratified", Pattern::stratified},
                                                            {"halton", Pattern::halton},
                                                            {"sobol", Pattern::sobol},
                                                            {"blue_noise", Pattern::blue_noise}};
  const auto found = patterns.find(kind);
  if (found != patterns.end()) return std::make_unique<HashedSampler>(found->second);
  std::string words = "kind: one of";
  for (const auto& [name, pattern] : patterns) (words += ' ') += name;
  throw std::invalid_argument(words);
}

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  sampler.generate(samples, seed);
  double mean = 0;
  for (std::size_t i = 1; i <= samples; ++i) {
    mean += (scene.sample(sampler) - mean) / static_cast<double>(i);
    sampler.advance();
  }
  return mean;
}

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: 0");
  if (scene.height != 0 && scene.width > most_samples / scene.height) {
    throw std::invalid_argument("scene: too large");
  }
  Image image{scene.width, scene.height, std::vector<double>(scene.width * scene.height)};
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const std::size_t column = k % scene.width, row = k / scene.width;
    const Scene pixel{scene.uses, [&](Sampler& s) { return scene.sample(column, row, s); }};
    image.pixels[k] = integrate(pixel, sampler, spp, hash(seed, k));
  }
  return image;
}

}  // namespace mc
