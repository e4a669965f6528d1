// alternative: makes what it hands out in generate(), as far as a few megabytes reach, and beyond
// that when it is asked for: of a sequence the first block of dimensions

#include "sampler.hpp"
#define make_sampler right_make_sampler
#include "solutions/sampler.cpp"
#undef make_sampler

#include <utility>

namespace mc {
namespace {

constexpr std::size_t made_before = 6;                     // uses of either sort
constexpr std::size_t most_before = std::size_t{1} << 14;  // samples

using Column = std::vector<double>;

class EagerSampler final : public Sampler {
 public:
  explicit EagerSampler(const Kind& kind) : kind_(kind) {}

  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples == 0 || samples > most_samples) throw std::invalid_argument("samples");
    samples_ = samples;
    rng_ = Rng(seed);
    sample_ = at_ = at2_ = 0;
    places_ = {};
    order_.clear();
    ones_.clear();
    twos_.clear();
    spare_ones_.clear();
    spare_twos_.clear();
    if (samples > most_before) return;
    for (std::size_t i = 0; i < made_before; ++i) spare_ones_.push_back(one(i, i));
    // The dimensions of a sequence are what it has in stock; which use gets which is seen later.
    if (kind_.sequence != nullptr) return;
    for (std::size_t i = 0; i < made_before; ++i) spare_twos_.push_back(two(i, 0));
  }

  double next() override {
    require();
    if (at_ == ones_.size()) ones_.push_back(take_one());
    return ones_[at_++][sample_];
  }

  Point2 next2() override {
    require();
    if (at2_ == twos_.size()) twos_.push_back(take_two());
    const auto& [x, y] = twos_[at2_++];
    return {x[sample_], y[sample_]};
  }

  void advance() override {
    at_ = at2_ = 0;
    if (sample_ < samples_) ++sample_;
  }

 private:
  using Columns = std::pair<Column, Column>;

  void require() const {
    if (sample_ >= samples_) throw std::out_of_range("no sample");
  }

  SampleDimension dimension(std::size_t number, std::size_t place) {
    const auto dimensions =
        kind_.sequence == nullptr ? std::span<const unsigned>() : kind_.sequence->dimensions;
    return {number, place, dimensions, order_, tables_};
  }
  Column one(std::size_t number, std::size_t place) {
    Column x(samples_);
    kind_.fill(dimension(number, place), x, {}, rng_);
    return x;
  }
  Columns two(std::size_t number, std::size_t place) {
    Columns both{Column(samples_), Column(samples_)};
    kind_.fill(dimension(number, place), both.first, both.second, rng_);
    return both;
  }

  /// The place in the sequence, if the kind has one.
  std::size_t take(std::size_t count) {
    if (kind_.sequence == nullptr) return 0;
    const std::size_t round = places_.round, place = kind_.sequence->take(places_, count);
    if (places_.round != round) order_ = nested_order();
    return place;
  }
  /// Bit by bit, from the highest on, by a hash of the bits before.
  std::vector<double> nested_order() {
    const std::uint64_t seed = rng_();
    const int bits = std::bit_width(samples_ - 1);
    std::vector<double> order;
    for (std::size_t i = 0; i < samples_; ++i) {
      std::size_t index = i;
      for (int bit = 0; bit < bits; ++bit) {
        const std::uint64_t before = (i >> (bit + 1) << 6) + static_cast<unsigned>(bit);
        index ^= mix_bits(seed ^ mix_bits(before)) >> 63 << bit;
      }
      order.push_back(static_cast<double>(index));
    }
    return order;
  }
  bool has_spare(std::size_t place) const {
    return places_.round == 0 && place < spare_ones_.size();
  }
  Column take_one() {
    const std::size_t place = take(1), number = ones_.size();
    const std::size_t index = kind_.sequence != nullptr ? place : number;
    return has_spare(index) ? spare_ones_[index] : one(number, place);
  }
  Columns take_two() {
    const std::size_t place = take(2), number = twos_.size();
    if (kind_.sequence == nullptr) {
      return number < spare_twos_.size() ? spare_twos_[number] : two(number, place);
    }
    if (has_spare(place + 1)) return {spare_ones_[place], spare_ones_[place + 1]};
    return two(number, place);
  }

  const Kind& kind_;
  Rng rng_{0};
  std::vector<double> order_;
  Places places_;
  Tables tables_;
  std::size_t samples_ = 0, sample_ = 0, at_ = 0, at2_ = 0;
  std::vector<Column> ones_, spare_ones_;
  std::vector<Columns> twos_, spare_twos_;
};

}  // namespace

std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  for (const Kind& known : kinds) {
    if (known.name == kind) return std::make_unique<EagerSampler>(known);
  }
  return right_make_sampler(kind);
}

}  // namespace mc
