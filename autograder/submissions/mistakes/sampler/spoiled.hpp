#pragma once
// The solution with its private members accessible. A mistake derives from the solution's sampler
// and does one thing wrong.

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "sampler.hpp"

#define make_sampler right_make_sampler
#define final
#define private protected
#include "solutions/sampler.cpp"
#undef private
#undef final
#undef make_sampler

/// The make_sampler() of a mistake: MAKE_SAMPLER(make_spoiled<Wrong>(kind))
#define MAKE_SAMPLER(...)                                        \
  std::unique_ptr<Sampler> make_sampler(std::string_view kind) { \
    return __VA_ARGS__;                                          \
  }

namespace mc {
namespace {

/// What a Wrong sampler derives from. It is of kind `made`, and keeps the seed.
struct Spoiled : ColumnSampler {
  static inline const Kind* made = nullptr;

  Spoiled() : ColumnSampler(*made) {}
  void generate(std::size_t samples, std::uint64_t seed) override {
    ColumnSampler::generate(samples, seed_ = seed);
  }

 protected:
  std::uint64_t seed_ = 0;
};

/// A Wrong sampler of one of the kinds of the solution: of every
/// kind, or only of one.
template <class Wrong>
std::unique_ptr<Sampler> make_spoiled(std::string_view kind, std::string_view only = "") {
  for (const Kind& known : kinds) {
    if (known.name != kind || (!only.empty() && only != kind)) continue;
    Spoiled::made = &known;
    return std::make_unique<Wrong>();
  }
  return right_make_sampler(kind);
}

using Fill = void(const SampleDimension&, std::span<double> x, std::span<double> y, Rng&);
using FillOne = void(const SampleDimension&, std::span<double> x, Rng&);

/// Fills by `one` for a next(), and by `two` for a next2().
template <FillOne* one, Fill* two>
void either(const SampleDimension& dim, std::span<double> x, std::span<double> y, Rng& rng) {
  y.empty() ? one(dim, x, rng) : two(dim, x, y, rng);
}

/// The solution's sampler, but one kind of it fills columns by other functions.
template <FillOne* one, Fill* two>
std::unique_ptr<Sampler> make_other_kind(std::string_view other, std::string_view kind) {
  static const Kind wrong{other, either<one, two>};
  if (kind == other) return std::make_unique<ColumnSampler>(wrong);
  return right_make_sampler(kind);
}

/// The solution's sampler, but one kind fills columns or takes dimensions of a sequence otherwise.
template <Fill* fill, const Sequence* sequence = &one_sequence>
std::unique_ptr<Sampler> make_wrong(std::string_view other, std::string_view kind) {
  static const Kind wrong{other, fill, sequence};
  if (kind == other) return std::make_unique<ColumnSampler>(wrong);
  return right_make_sampler(kind);
}

[[maybe_unused]] void stratified1(const SampleDimension& dim, std::span<double> x, Rng& rng) {
  stratified(dim, x, {}, rng);
}

}  // namespace
}  // namespace mc
