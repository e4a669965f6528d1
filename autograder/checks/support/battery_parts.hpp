#pragma once
// Shared by the parts of the battery; only battery*.cpp include this.

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "checks/support/battery.hpp"
#include "checks/support/distributions.hpp"

namespace mc::checks::battery {

constexpr double parts = 10;  // the alpha of a call is divided among them

inline std::string name_of(const Uniforms& numbers, std::size_t position) {
  if (numbers.name) return numbers.name(position);
  return numbers.positions == 1 ? "values" : fmt::format("position {}", position);
}

/// The tests of one part. Keeps the smallest p-value, and records a randomly chosen one, which is
/// uniform under the null hypothesis (the smallest is not).
class Family {
 public:
  Family(const Uniforms& numbers, const Randomness& claim, const char* part, std::size_t size)
      : numbers_(numbers),
        claim_(claim),
        part_(part),
        size_(std::max<std::size_t>(size, 1)),
        chosen_(side_rng()() % size_) {}

  /// `describe` returns what was measured, if the test fails. `hint` is for numbers without another
  /// visible fault.
  template <class Describe>
  void add(double p, bool is_continuous, Describe describe, const Likely& hint = {}) {
    if (count_++ == chosen_ && is_continuous) {
      record(protocol::RecordKind::p_value,
             protocol::text_of({claim_.words + ": " + part_, p, claim_.alpha / parts}));
    }
    const double alpha = claim_.alpha / parts / static_cast<double>(size_);
    if (p >= alpha) return;
    if (p < least_ || measured_.empty()) {
      least_ = p;
      measured_ = describe();
      hint_ = hint;
    }
  }

  /// Of the test that rejected with the smallest p-value.
  std::optional<Failure> failure() const {
    if (measured_.empty()) return {};
    record(protocol::RecordKind::p_value,
           protocol::text_of({claim_.words + ": " + part_,
                              std::min(1.0, least_ * static_cast<double>(size_)),
                              claim_.alpha / parts}));
    Likely fault = claim_.explain ? claim_.explain() : Likely{};
    const bool is_open = claim_.expected.empty() && !claim_.is_certain;
    if (fault == Likely{} && is_open) fault = visible_fault(numbers_, claim_);
    if (fault == Likely{} && is_open && hint_ != Likely{}) {
      fault.text = hint_.text + "; " + claim_.rule;
    }
    return Failure{
        numbers_.call + ": " + measured_,
        claim_.expected.empty() ? "independent random numbers, uniform in [0, 1)" : claim_.expected,
        fmt::format("{}: a correct answer fails this test once in {:.1g} runs", claim_.words,
                    parts / claim_.alpha),
        fault, claim_.rule};
  }

 private:
  const Uniforms& numbers_;
  const Randomness& claim_;
  const char* part_;
  std::size_t size_, chosen_, count_ = 0;
  double least_ = 1;
  std::string measured_;
  Likely hint_;
};

/// P(|sum of n independent random directions|^2 >= squared): Rayleigh's test, with the second-order
/// correction of Zar, "Biostatistical analysis", 27.1; an upper bound in the far tail.
inline double p_of_resultant(double squared, double n) {
  return std::exp(std::sqrt(1 + 4 * n + 4 * (n * n - std::min(squared, n * n))) - (1 + 2 * n));
}

/// Values closer than this count as equal: rounding may separate them.
inline double width_of_equal(const Uniforms& numbers) {
  return std::ldexp(1.0, -std::min(44, numbers.bits - 2));
}

inline std::size_t repeats_in(std::vector<double> sorted, double width) {
  sort_uniforms(sorted);
  std::size_t repeats = 0;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) repeats += sorted[i + 1] - sorted[i] < width;
  return repeats;
}

using Complex = std::complex<float>;

/// exp(2 pi i u) of all values; products of its powers give all waves.
std::vector<Complex> phases_of(std::span<const double> values);

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;  ///< of positions

/// The pairs of positions to compare: all of up to 40 positions, or a selection.
Pairs compared_pairs(std::size_t positions);

std::optional<Failure> test_waves(const Uniforms& numbers, const Randomness& claim,
                                  const Pairs& pairs, std::span<const Complex> z);
std::optional<Failure> test_triples(const Uniforms& numbers, const Randomness& claim,
                                    std::span<const Complex> z);
std::optional<Failure> test_bit_pairs(const Uniforms& numbers, const Randomness& claim,
                                      const Pairs& pairs);

}  // namespace mc::checks::battery
