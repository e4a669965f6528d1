// alternative: a base class with a virtual function for each pattern, a class for each kind,
// columns in maps, std::mt19937_64 and std::shuffle throughout

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>

#include "sampler.hpp"

namespace mc {
namespace {

using Numbers = std::vector<double>;
using Points = std::vector<Point2>;

class TextbookSampler : public Sampler {
 public:
  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0) throw std::invalid_argument("samples must not be 0");
    if (samples > most_samples) throw std::invalid_argument("samples: too many");
    // All 64 bits of the seed, and mixed: neighbors begin far apart.
    std::seed_seq words{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
    random_.seed(words);
    samples_ = samples;
    sample_ = 0;
    next_ = next2_ = 0;
    numbers_.clear();
    points_.clear();
    taken_ = 0;
  }

  double next() override {
    check();
    auto found = numbers_.find(next_);
    if (found == numbers_.end()) found = numbers_.emplace(next_, make_numbers()).first;
    ++next_;
    return found->second.at(sample_);
  }

  Point2 next2() override {
    check();
    auto found = points_.find(next2_);
    if (found == points_.end()) found = points_.emplace(next2_, make_points()).first;
    ++next2_;
    return found->second.at(sample_);
  }

  void advance() override {
    next_ = next2_ = 0;
    if (sample_ < samples_) ++sample_;
  }

 protected:
  virtual Numbers make_numbers() = 0;
  virtual Points make_points() = 0;

  std::size_t samples() const { return samples_; }
  double uniform() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  bool is_first_next2() const { return next2_ == 0; }

  /// A random number of stratum i of n.
  double within(std::size_t i, std::size_t n) {
    const double low = static_cast<double>(i) / static_cast<double>(n);
    const double high = static_cast<double>(i + 1) / static_cast<double>(n);
    const double x = (static_cast<double>(i) + uniform()) / static_cast<double>(n);
    return x < low ? low : x < high ? x : std::nextafter(high, 0.0);
  }

  template <class T>
  void shuffle_all(std::vector<T>& values) {
    std::shuffle(values.begin(), values.end(), random_);
  }

  std::mt19937_64 random_;
  std::size_t taken_ = 0;  // dimensions of a sequence

 private:
  void check() const {
    if (sample_ >= samples_) throw std::out_of_range("no sample");
  }

  std::size_t samples_ = 0, sample_ = 0, next_ = 0, next2_ = 0;
  std::map<std::size_t, Numbers> numbers_;
  std::map<std::size_t, Points> points_;
};

class Independent final : public TextbookSampler {
  Numbers make_numbers() override {
    Numbers numbers(samples());
    for (double& x : numbers) x = uniform();
    return numbers;
  }
  Points make_points() override {
    Points points(samples());
    for (Point2& p : points) {
      p.x = uniform();
      p.y = uniform();
    }
    return points;
  }
};

class Stratified : public TextbookSampler {
 protected:
  Numbers make_numbers() override {
    Numbers numbers;
    for (std::size_t i = 0; i < samples(); ++i) numbers.push_back(within(i, samples()));
    shuffle_all(numbers);
    return numbers;
  }
  /// Chiu, Shirley and Wang: every column of cells and every row has its own permutation.
  Points make_points() override {
    const Grid grid = strata(samples());
    std::vector<std::vector<std::size_t>> fine_x(grid.nx), fine_y(grid.ny);
    for (auto& column : fine_x) {
      column.resize(grid.ny);
      std::iota(column.begin(), column.end(), std::size_t{0});
      shuffle_all(column);
    }
    for (auto& row : fine_y) {
      row.resize(grid.nx);
      std::iota(row.begin(), row.end(), std::size_t{0});
      shuffle_all(row);
    }
    Points points;
    for (std::size_t j = 0; j < grid.ny; ++j) {
      for (std::size_t i = 0; i < grid.nx; ++i) {
        points.push_back({within(i * grid.ny + fine_x[i][j], samples()),
                          within(j * grid.nx + fine_y[j][i], samples())});
      }
    }
    shuffle_all(points);
    return points;
  }
};

/// A bluer pattern than is asked for: twice as many candidates.
class BlueNoise final : public Stratified {
  Points make_points() override {
    if (!is_first_next2()) return Stratified::make_points();
    Numbers x(samples()), y(samples());
    Rng rng(random_());
    best_candidate(x, y, 2, rng);
    Points points;
    for (std::size_t i = 0; i < samples(); ++i) points.push_back({x[i], y[i]});
    shuffle_all(points);
    return points;
  }
};

/// One dimension after the other of 32, and then again in another order.
class Sequence : public TextbookSampler {
 protected:
  virtual Numbers dimension(std::size_t d) = 0;

 private:
  Numbers make_numbers() override { return column(take(1)); }
  Points make_points() override {
    const std::size_t first = take(2);
    const Numbers x = column(first), y = column(first + 1);
    Points points;
    for (std::size_t i = 0; i < x.size(); ++i) points.push_back({x[i], y[i]});
    return points;
  }

  std::size_t take(std::size_t count) {
    if (taken_ == 0) order_.clear();
    if (taken_ % 32 + count > 32) taken_ += 32 - taken_ % 32;
    if (taken_ > 0 && taken_ % 32 == 0) {
      order_.resize(samples());
      std::iota(order_.begin(), order_.end(), std::size_t{0});
      shuffle_all(order_);
    }
    taken_ += count;
    return (taken_ - count) % 32;
  }
  Numbers column(std::size_t d) {
    const Numbers in_sequence = dimension(d);
    if (order_.empty()) return in_sequence;
    Numbers in_order;
    for (const std::size_t i : order_) in_order.push_back(in_sequence[i]);
    return in_order;
  }

  std::vector<std::size_t> order_;
};

class Halton final : public Sequence {
  Numbers dimension(std::size_t d) override {
    Numbers column(samples());
    if (d == 0) {
      radical_inverses(2, 0, column);
      owen_scramble(column, random_());
    } else {
      radical_inverses_scrambled(primes(d + 1).back(), 0, column, random_());
    }
    return column;
  }
};

class Sobol final : public Sequence {
  Numbers dimension(std::size_t d) override {
    Numbers column(samples());
    sobol(static_cast<unsigned>(d), 0, column);
    owen_scramble(column, random_());
    return column;
  }
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  if (kind == "independent") return std::make_unique<Independent>();
  if (kind == "stratified") return std::make_unique<Stratified>();
  if (kind == "halton") return std::make_unique<Halton>();
  if (kind == "sobol") return std::make_unique<Sobol>();
  if (kind == "blue_noise") return std::make_unique<BlueNoise>();
  throw std::invalid_argument("kind is none of independent, stratified, halton, sobol, blue_noise");
}

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  if (samples == 0) throw std::invalid_argument("samples: none");
  sampler.generate(samples, seed);
  std::vector<double> values(samples);
  for (double& value : values) {
    value = scene.sample(sampler);
    sampler.advance();
  }
  return mean(values);
}

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: none");
  if (scene.width > most_samples || scene.height > most_samples ||
      scene.width * scene.height > most_samples) {
    throw std::invalid_argument("scene: too many pixels");
  }
  std::mt19937_64 seeds(mix_bits(seed));
  Image image{scene.width, scene.height, std::vector<double>(scene.width * scene.height)};
  for (std::size_t x = 0; x < scene.width; ++x) {
    for (std::size_t y = 0; y < scene.height; ++y) {
      const auto one = [&](Sampler& s) { return scene.sample(x, y, s); };
      image.pixels[y * scene.width + x] = integrate({scene.uses, one}, sampler, spp, seeds());
    }
  }
  return image;
}

}  // namespace mc
