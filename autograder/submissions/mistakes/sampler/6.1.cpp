// Mistakes in task 6.1.
#include "autograder/submissions/mistakes/sampler/spoiled.hpp"

#include <algorithm>

// mistake: throws for an unknown kind without listing the known ones
// hint: a list of all kinds helps a user who mistypes one
namespace mc::names_no_kinds {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  for (const Kind& known : kinds) {
    if (known.name == kind) return right_make_sampler(kind);
  }
  throw std::invalid_argument("unknown kind");
}
}  // namespace mc::names_no_kinds

// mistake: starts every sample dimension with the same generator
// fails: 6.2, 6.3, 6.4
// hint: numbers are used again for another
namespace mc::one_generator_for_every_use {
struct Wrong : ColumnSampler {
  using ColumnSampler::ColumnSampler;
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed);
    first_ = rng_;
  }
  double next() override {
    if (next_ == ready_) rng_ = first_;
    return ColumnSampler::next();
  }
  Point2 next2() override {
    if (next2_ == ready2_) rng_ = first_;
    return ColumnSampler::next2();
  }

 private:
  Rng first_{0};
};

MAKE_SAMPLER(make_spoiled<Wrong>(kind))
}  // namespace mc::one_generator_for_every_use

// mistake: treats an unknown kind as "independent"
// hint: there is no such kind of sampler
namespace mc::unknown_is_independent {
std::unique_ptr<Sampler> make_sampler(std::string_view kind) {
  const auto known = [&](const Kind& one) { return one.name == kind; };
  const bool is_known = std::any_of(std::begin(kinds), std::end(kinds), known);
  return right_make_sampler(is_known ? kind : "independent");
}
}  // namespace mc::unknown_is_independent

// mistake: mirrors the first half of the samples of a next() in the second half
// hint: for every coordinate of every sample
namespace mc::antithetic_half {
void mirrored(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  independent1(dim, x, rng);
  const std::size_t half = x.size() / 2;
  for (std::size_t i = 0; i < half; ++i) x[half + i] = 1 - 0x1p-53 - x[i];
}

MAKE_SAMPLER(make_other_kind<mirrored, independent2>("independent", kind))
}  // namespace mc::antithetic_half
