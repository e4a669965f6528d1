// Mistakes in task 6.4.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

#include <algorithm>

// mistake: starts a sample dimension at the sample that first requests it
// hint: make the whole column, including earlier samples
namespace mc::columns_begin_late {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    begins_.clear();
  }
  double next() override {
    if (next_ == begins_.size()) begins_.push_back(sample_);
    if (next_ == ready_) return ColumnSampler::next();  // makes the column and comes back
    const std::size_t use = next_++;
    return ones_[use].x[sample_ - begins_[use]];
  }

 private:
  std::vector<std::size_t> begins_;
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::columns_begin_late

// mistake: gives fewer samples the first numbers of old, longer columns
// hint: reset counters, columns and generators
namespace mc::columns_never_shrink {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    wanted_ = samples;
    most_ = samples_ = std::max(most_, samples);
  }
  void advance() override {
    if (sample_ + 1 >= wanted_) samples_ = wanted_;  // this was the last
    ColumnSampler::advance();
  }

 private:
  std::size_t wanted_ = 0, most_ = 0;
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::columns_never_shrink

// mistake: seeds its generator in the first generate() only
// hint: the previous integration left something behind
namespace mc::goes_on_with_its_generator {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    const Rng before = rng_;
    const bool first = samples_ == 0;
    ColumnSampler::generate(samples, seed);
    if (!first) rng_ = before;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::goes_on_with_its_generator

// mistake: does not limit the number of samples, and allocates
// hint: at most most_samples
// limit: memory
namespace mc::memory_decides {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    const std::vector<double> column(samples > most_samples ? samples : 0);
    ColumnSampler::generate(samples, seed);
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::memory_decides

// mistake: accepts 0 samples
// hint: there must be at least one sample
namespace mc::no_samples_are_fine {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    if (samples > 0) return ColumnSampler::generate(samples, seed);
    samples_ = sample_ = next_ = next2_ = ready_ = ready2_ = 0;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::no_samples_are_fine

// mistake: keeps the columns if the number of samples did not change
// hint: the previous integration left something behind
namespace mc::old_columns {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    const bool same = samples == samples_ && sample_ < samples_;
    const std::size_t ready = ready_, ready2 = ready2_;
    ColumnSampler::generate(samples, seed);
    if (!same) return;
    ready_ = ready;
    ready2_ = ready2;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::old_columns

// mistake: keeps the columns for the same seed and number of samples, whose requests may differ
// hint: the previous integration left something behind
namespace mc::columns_of_the_same_seed {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    const bool same = samples == samples_ && seed == seed_ && sample_ < samples_;
    const std::size_t ready = ready_, ready2 = ready2_;
    Spoiled::generate(samples, seed);
    if (same) ready_ = ready, ready2_ = ready2;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::columns_of_the_same_seed

// mistake: does not go back to sample 0 in generate()
// hint: reset counters, columns
namespace mc::old_sample_number {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    const std::size_t before = sample_;
    ColumnSampler::generate(samples, seed);
    sample_ = before % samples;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::old_sample_number

// mistake: draws all numbers from one generator, as random() does
// hint: must not leave its numbers to the next one
namespace mc::one_stream {
struct Wrong : Spoiled {
  double next() override {
    require_sample();
    return to_unit(rng_());
  }
  Point2 next2() override {
    const double x = next();
    return {x, next()};
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "independent"))
}  // namespace mc::one_stream

// mistake: starts again with the first sample after the last one
// hint: there is no sample before generate() and after the last one
namespace mc::round_and_round {
struct Wrong : Spoiled {
  void advance() override {
    next_ = next2_ = 0;
    if (samples_ > 0) sample_ = (sample_ + 1) % samples_;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::round_and_round

// mistake: takes one step of a linear congruential generator from the seed as the first number
// hint: mix all 64 bits of the seed
namespace mc::seed_is_the_state {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    first_ = to_unit((seed + 1) * 6364136223846793005u + 1442695040888963407u);
  }
  double next() override {
    const double x = ColumnSampler::next();  // the right numbers, but for the first
    return sample_ == 0 && next_ == 1 ? first_ : x;
  }

 private:
  double first_ = 0;
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "independent"))
}  // namespace mc::seed_is_the_state

// mistake: loses the upper half of the seed
// hint: do not truncate the seed to 32 bits
namespace mc::seed_of_32_bits {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, static_cast<unsigned>(seed));
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::seed_of_32_bits

// mistake: seeds a sample dimension by the sample that first requests it
// hint: from the seed and its own number only
namespace mc::seeded_by_the_first_request {
struct Wrong : Spoiled {
  double next() override {
    if (next_ == ready_) rng_ = Rng(rng_() ^ sample_);
    return ColumnSampler::next();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::seeded_by_the_first_request

// mistake: seeds a sample dimension with the integration's seed plus its index
// hint: the number of a dimension, not their sum
namespace mc::seed_plus_use {
struct Wrong : Spoiled {
  double next() override {
    if (next_ == ready_) rng_ = Rng(seed_ + ready_ + ready2_);
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (next2_ == ready2_) rng_ = Rng(seed_ + ready_ + ready2_);
    return ColumnSampler::next2();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::seed_plus_use

// mistake: shares one generator among all samplers, which generate() seeds
// hint: both samplers change a static or global variable
namespace mc::static_generator {
Rng shared(0);

struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    shared = rng_;
  }
  double next() override {
    if (next_ == ready_) rng_ = Rng(shared());
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (next2_ == ready2_) rng_ = Rng(shared());
    return ColumnSampler::next2();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::static_generator

// mistake: throws in advance() after the last sample
// hint: advance() never throws
namespace mc::throws_at_the_end {
struct Wrong : Spoiled {
  void advance() override {
    require_sample();
    ColumnSampler::advance();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::throws_at_the_end

// mistake: makes columns only for the requests of the first sample
// hint: a later sample may be the first to request a sample dimension
namespace mc::uses_of_the_first_sample {
struct Wrong : Spoiled {
  double next() override {
    if (sample_ > 0 && next_ == ready_) throw std::out_of_range("more than the first sample");
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (sample_ > 0 && next2_ == ready2_) throw std::out_of_range("more than the first sample");
    return ColumnSampler::next2();
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::uses_of_the_first_sample

// mistake: returns 0 after the last sample
// hint: there is no sample before generate() and after the last one
namespace mc::zero_after_the_end {
struct Wrong : Spoiled {
  double next() override { return sample_ < samples_ ? ColumnSampler::next() : 0; }
  Point2 next2() override { return sample_ < samples_ ? ColumnSampler::next2() : Point2{}; }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::zero_after_the_end

// mistake: counts next() and next2() together: a next() is half of a next2()
// fails: 6.3, 6.7
// hint: count next() and next2() in separate counters
namespace mc::one_counter {
struct Wrong : Spoiled {
  double next() override { return next2().x; }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::one_counter

// mistake: makes sixteen columns in generate(), requested or not
// hint: make a column when it is first requested
namespace mc::eager_columns {
struct Wrong : Spoiled {
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    while (samples > 1 && next_ < 16) next();
    next_ = 0;
  }
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind, "stratified"))
}  // namespace mc::eager_columns
