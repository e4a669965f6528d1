// Mistakes in task 6.1.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

#include <chrono>

// mistake: throws for an unknown kind without listing the known ones
// hint: a list of all kinds helps a user who mistypes one
namespace mc::names_no_kinds {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) try {
  return right_make_sampler(kind);
} catch (const std::invalid_argument&) {
  throw std::invalid_argument("unknown kind");
}
}  // namespace mc::names_no_kinds

// mistake: starts every sample dimension with the same generator
// fails: 6.2, 6.3, 6.4
// hint: numbers are used again for another
namespace mc::one_generator_for_every_use {
struct Wrong : Spoiled {
  double next() override {
    if (next_ == ready_) rng_ = Rng(seed_);
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (next2_ == ready2_) rng_ = Rng(seed_);
    return ColumnSampler::next2();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::one_generator_for_every_use

// mistake: treats an unknown kind as "independent"
// hint: there is no such kind of sampler
namespace mc::unknown_is_independent {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) try {
  return right_make_sampler(kind);
} catch (const std::invalid_argument&) {
  return right_make_sampler("independent");
}
}  // namespace mc::unknown_is_independent

// mistake: mirrors the first half of the samples of a next() in the second half
// hint: for every coordinate of every sample
namespace mc::antithetic_half {
void mirrored(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  independent(dim, x, {}, rng);
  const std::size_t half = x.size() / 2;
  for (std::size_t i = 0; i < half; ++i) x[half + i] = 1 - 0x1p-53 - x[i];
}

MAKE_SAMPLER(make_other_kind<mirrored, independent>("independent", kind))
}  // namespace mc::antithetic_half

// mistake: seeds itself from the clock
// fails: 6.2, 6.3, 6.4, 6.7
// hint: use no clock and no global generator
namespace mc::clock_decides {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
    ColumnSampler::generate(samples, mix_bits(seed) + static_cast<std::uint64_t>(now));
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::clock_decides

// mistake: stores four numbers per sample; further requests read the next sample's
// fails: 6.4
// hint: numbers are used again
namespace mc::takes_from_the_next_sample {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    numbers_.resize(4 * samples);
    uniforms(rng_, numbers_);
    used_ = 0;
  }
  double next() override {
    require_sample();
    return numbers_[(4 * sample_ + used_++) % numbers_.size()];
  }
  Point2 next2() override {
    const double x = next();
    return {x, next()};
  }
  void advance() override {
    ColumnSampler::advance();
    used_ = 0;
  }

 private:
  std::vector<double> numbers_;
  std::size_t used_ = 0;
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "independent"))
}  // namespace mc::takes_from_the_next_sample

// mistake: resets the counter of next() in advance(), but not that of next2()
// fails: 6.2, 6.3, 6.4, 6.7
// hint: a sample that ends early must not leave its numbers
// limit: time
namespace mc::counter_goes_on {
struct Wrong : Spoiled {
  void advance() override {
    const std::size_t before = next2_;
    ColumnSampler::advance();
    next2_ = std::min(before, ready2_);
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::counter_goes_on

// mistake: draws numbers of 32 bits
// hint: only 32 of 53
namespace mc::numbers_of_32_bits {
void short_numbers(const SampleDimension&, std::span<double> x, std::span<double> y, Rng& rng) {
  for (double& value : x) value = static_cast<double>(rng() >> 32) * 0x1p-32;
  for (double& value : y) value = static_cast<double>(rng() >> 32) * 0x1p-32;
}
void one_short_number(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  short_numbers(dim, x, {}, rng);
}

MAKE_SAMPLER(make_other_kind<one_short_number, short_numbers>("independent", kind))
}  // namespace mc::numbers_of_32_bits

// mistake: has 32 columns for next(), and uses the last for all others
// hint: numbers are used again
namespace mc::room_for_32_dimensions {
struct Wrong : Spoiled {
  double next() override {
    next_ = std::min<std::size_t>(next_, 31);
    return ColumnSampler::next();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "independent"))
}  // namespace mc::room_for_32_dimensions

// mistake: makes the column again for every number
// hint: did not end within
// limit: time
namespace mc::a_column_for_each_number {
struct Wrong : Spoiled {
  double next() override {
    require_sample();
    Rng rng(mix_bits(seed_ ^ mix_bits(next_++)));
    std::vector<double> column(samples_);
    uniforms(rng, column);
    uniforms(rng, column);
    return column[sample_];
  }
  Point2 next2() override {
    const double x = next();
    return {x, next()};
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "independent"))
}  // namespace mc::a_column_for_each_number

// mistake: compares kinds as strings that end in a 0, which a string_view need not
// hint: the kind is all characters of the string_view
namespace mc::kinds_that_end_in_0 {
MAKE_SAMPLER(right_make_sampler(std::string(kind).c_str()))
}  // namespace mc::kinds_that_end_in_0
