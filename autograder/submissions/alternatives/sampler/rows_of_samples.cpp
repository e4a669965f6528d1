// alternative: stores the numbers of a sample side by side, in rows that are laid out anew when
// there are more uses; Poisson-disk patterns filled with best candidates

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "sampler.hpp"

namespace mc {
namespace {

/// N rows, which grow to the right.
template <class T>
class Rows {
 public:
  std::size_t columns = 0;

  void clear(std::size_t rows) {
    rows_ = rows;
    columns = width_ = 0;
    values_.clear();
  }
  T& at(std::size_t row, std::size_t column) { return values_[row * width_ + column]; }
  void add_column() {
    if (columns == width_) {
      const std::size_t wider = width_ == 0 ? 1 : 2 * width_;
      std::vector<T> values(rows_ * wider);
      for (std::size_t row = 0; row < rows_; ++row) {
        for (std::size_t c = 0; c < width_; ++c) values[row * wider + c] = at(row, c);
      }
      values_ = std::move(values);
      width_ = wider;
    }
    ++columns;
  }

 private:
  std::size_t rows_ = 0, width_ = 0;
  std::vector<T> values_;
};

using Column = std::vector<double>;

/// x[order[i]], for an order that several columns may share.
Column in_order(const Column& x, const Column& order) {
  Column ordered;
  for (const double i : order) ordered.push_back(x[static_cast<std::size_t>(i)]);
  return ordered;
}

Column random_order(std::size_t size, Rng& rng) {
  Column order(size);
  for (std::size_t i = 0; i < size; ++i) order[i] = static_cast<double>(i);
  shuffle(order, rng);
  return order;
}

/// What differs from kind to kind: the columns of use `number`, which is one of a next() or two of
/// a next2(), and the first dimension of a sequence for it.
struct Request {
  std::size_t samples, axes, number, dimension;
  std::uint64_t seed;
};
using Maker = std::function<std::vector<Column>(const Request&, Rng&)>;

std::vector<Column> independent_columns(const Request& request, Rng& rng) {
  std::vector<Column> columns(request.axes, Column(request.samples));
  for (Column& column : columns) uniforms(rng, column);
  return columns;
}

std::vector<Column> stratified_columns(const Request& request, Rng& rng) {
  std::vector<Column> columns(request.axes, Column(request.samples));
  if (request.axes == 1) {
    stratified_1d(columns[0], rng);
  } else {
    multi_jittered(columns[0], columns[1], strata(request.samples), rng);
  }
  const Column order = random_order(request.samples, rng);
  for (Column& column : columns) column = in_order(column, order);
  return columns;
}

/// A Poisson-disk pattern of fewer points than N, and the farthest of many candidates for the rest.
std::vector<Column> blue_columns(const Request& request, Rng& rng) {
  if (request.axes == 1 || request.number > 0) return stratified_columns(request, rng);
  const std::size_t n = request.samples;
  double radius = 0.87 / std::sqrt(static_cast<double>(n));
  PointSet pattern = poisson_disk(radius, rng);
  while (pattern.size() > n) pattern = poisson_disk(radius *= 1.02, rng);
  std::vector<Column> columns(2);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto from = pattern.column(axis);
    columns[axis].assign(from.begin(), from.end());
  }
  while (columns[0].size() < n) {
    Point2 farthest;
    double distance = -1;
    for (std::size_t candidate = 0; candidate <= columns[0].size(); ++candidate) {
      const Point2 p{to_unit(rng()), to_unit(rng())};
      double nearest = 1;
      for (std::size_t i = 0; i < columns[0].size() && nearest > distance; ++i) {
        nearest = std::min(nearest, toroidal_distance_squared(p, {columns[0][i], columns[1][i]}));
      }
      if (nearest <= distance) continue;
      distance = nearest;
      farthest = p;
    }
    columns[0].push_back(farthest.x);
    columns[1].push_back(farthest.y);
  }
  const Column order = random_order(n, rng);
  return {in_order(columns[0], order), in_order(columns[1], order)};
}

constexpr std::size_t block = 8;

std::size_t power_of_2(std::size_t least) {
  std::size_t power = 1;
  while (power < least) power *= 2;
  return power;
}

/// Of 0 … 2^m - 1, each half of each interval changes places with the other one or does not; the
/// first `size` of them.
Column nested_order(std::size_t size, Rng& rng) {
  Column order(power_of_2(size));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<double>(i);
  for (std::size_t half = order.size() / 2; half > 0; half /= 2) {
    for (std::size_t first = 0; first < order.size(); first += 2 * half) {
      const auto at = [&](std::size_t i) {
        return order.begin() + static_cast<std::ptrdiff_t>(first + i);
      };
      if (rng() >> 63 != 0) std::swap_ranges(at(0), at(half), at(half));
    }
  }
  order.resize(size);
  return order;
}

template <class Fill>
Maker sequence(Fill fill) {
  return [fill](const Request& request, Rng& rng) {
    const std::size_t size =
        request.dimension < block ? request.samples : power_of_2(request.samples);
    std::vector<Column> columns(request.axes, Column(size));
    for (std::size_t axis = 0; axis < request.axes; ++axis) {
      fill((request.dimension + axis) % block, columns[axis], rng());
    }
    if (request.dimension < block) return columns;
    Rng order_of_block(mix_bits(request.seed ^ mix_bits(request.dimension / block)));
    const Column order = nested_order(request.samples, order_of_block);
    for (Column& column : columns) column = in_order(column, order);
    return columns;
  };
}

Maker maker_of(std::string_view kind) {
  if (kind == "independent") return independent_columns;
  if (kind == "stratified") return stratified_columns;
  if (kind == "blue_noise") return blue_columns;
  if (kind == "sobol") {
    return sequence([](std::size_t d, Column& x, std::uint64_t seed) {
      constexpr unsigned dimensions[] = {0, 1, 4, 6, 16, 20, 15, 21};
      sobol(dimensions[d], 0, x);
      owen_scramble(x, seed);
    });
  }
  if (kind == "halton") {
    return sequence([](std::size_t d, Column& x, std::uint64_t seed) {
      if (d > 0) return radical_inverses_scrambled(primes(d + 1)[d], 0, x, seed);
      sobol(0, 0, x);  // base 2 is van der Corput's
      owen_scramble(x, seed);
    });
  }
  throw std::invalid_argument("kind '" + std::string(kind) +
                              "': stratified, sobol, halton, blue_noise and independent are known");
}

class RowSampler final : public Sampler {
 public:
  explicit RowSampler(Maker make) : make_(std::move(make)) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples - 1 >= most_samples) throw std::invalid_argument("bad number of samples");
    samples_ = samples;
    seed_ = mix_bits(seed ^ 0x243f6a8885a308d3u);
    row_ = next_ = next2_ = dimension_ = 0;
    halves_.clear();
    ones_.clear(samples);
    twos_.clear(samples);
  }
  double next() override {
    if (row_ >= samples_) throw std::out_of_range("next: no sample");
    if (next_ == ones_.columns) {
      const auto columns = made(1, next_);
      ones_.add_column();
      for (std::size_t i = 0; i < samples_; ++i) ones_.at(i, next_) = columns[0][i];
    }
    return ones_.at(row_, next_++);
  }
  Point2 next2() override {
    if (row_ >= samples_) throw std::out_of_range("next2: no sample");
    if (next2_ == twos_.columns) {
      const auto columns = made(2, next2_);
      twos_.add_column();
      for (std::size_t i = 0; i < samples_; ++i) {
        twos_.at(i, next2_) = {columns[0][i], columns[1][i]};
      }
    }
    return twos_.at(row_, next2_++);
  }
  void advance() override {
    next_ = next2_ = 0;
    row_ += row_ < samples_ ? 1 : 0;
  }

 private:
  /// Every use has its own generator, whose seed does not depend on the order of uses.
  std::vector<Column> made(std::size_t axes, std::size_t number) {
    Rng rng(mix_bits(seed_ + number) + axes);
    if (axes == 1 && !halves_.empty()) {
      const std::size_t half = halves_.back();
      halves_.clear();
      return make_({samples_, axes, number, half, seed_}, rng);
    }
    if (dimension_ % block == 0) halves_.clear();
    if (axes == 1) halves_ = {dimension_ + 1};
    dimension_ += 2;
    return make_({samples_, axes, number, dimension_ - 2, seed_}, rng);
  }

  Maker make_;
  std::uint64_t seed_ = 0;
  std::size_t samples_ = 0, row_ = 0, next_ = 0, next2_ = 0, dimension_ = 0;
  std::vector<std::size_t> halves_;  // one or none
  Rows<double> ones_;
  Rows<Point2> twos_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  return std::make_unique<RowSampler>(maker_of(kind));
}

double integrate(const Scene& scene, Sampler& sampler, std::size_t samples, std::uint64_t seed) {
  if (samples == 0) throw std::invalid_argument("samples must be at least 1");
  double sum = 0, lost = 0;  // Kahan's sum
  sampler.generate(samples, seed);
  for (std::size_t left = samples; left > 0; --left) {
    const double value = scene.sample(sampler) - lost;
    const double more = sum + value;
    lost = (more - sum) - value;
    sum = more;
    sampler.advance();
  }
  return sum / static_cast<double>(samples);
}

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp must be at least 1");
  if (scene.width != 0 && most_samples / scene.width < scene.height) {
    throw std::invalid_argument("scene.width * scene.height is too much");
  }
  Image image;
  image.width = scene.width;
  image.height = scene.height;
  for (std::size_t row = 0; row < scene.height; ++row) {
    const std::uint64_t of_row = mix_bits(mix_bits(seed) + row);
    for (std::size_t column = 0; column < scene.width; ++column) {
      Scene pixel;
      pixel.uses = scene.uses;
      pixel.sample = [&](Sampler& s) { return scene.sample(column, row, s); };
      image.pixels.push_back(integrate(pixel, sampler, spp, mix_bits(of_row ^ (column << 32))));
    }
  }
  return image;
}

}  // namespace mc
