#pragma once
// Radical inverses, primes and Sobol' points by their definitions, and results of mistakes.

#include "checks/support/checks.hpp"
#include "checks/support/sobol_exact.hpp"

namespace mc::checks {

inline constexpr double half_ulp = 0x1p-53;  // half a unit in the last place of 1
/// The header's bound, plus the rounding error of the exact value.
inline constexpr double inverse_tolerance = 4.5 * half_ulp;
inline constexpr std::uint64_t last_index = std::numeric_limits<std::uint64_t>::max();
inline constexpr std::uint64_t sobol_end = std::uint64_t{1} << 32;  // of the indices of 5.5

inline double wrapped(double x) {
  return x - std::floor(x);
}

/// The claim that the shift of `what` is uniform and independent for each axis.
inline Randomness uniform_shift(const std::string& what, const Likely& repeated = {}) {
  return {.words = "the shift of " + what + " is uniform in the unit cube",
          .rule = "draw a uniform number in [0, 1) for each axis",
          .repeated = repeated,
          .same = "the same shift on every axis moves points along the diagonal"_likely};
}

/// The radical inverse, accurate to 100 bits: the mirrored digits over the power of the base above
/// them, both below 2^96.
inline Exact exact_inverse(unsigned base, std::uint64_t index) {
  unsigned __int128 mirrored = 0, power = 1;
  for (; index > 0; index /= base, power *= base) mirrored = mirrored * base + index % base;
  const auto exact = [](unsigned __int128 number) {
    return Exact(static_cast<double>(number >> 48)) * Exact(0x1p48) +
           Exact(static_cast<double>(number & 0xffffffffffff));
  };
  return exact(mirrored) / exact(power);
}

inline double inverse(unsigned base, std::uint64_t index) {
  return static_cast<double>(exact_inverse(base, index));
}

inline Values inverses(unsigned base, std::uint64_t first, std::size_t n) {
  return each(domain::in_a_row(first, n), [=](std::uint64_t i) { return inverse(base, i); });
}

/// i / N: the first axis of Hammersley points.
inline Values steps(std::size_t n) {
  const auto size = static_cast<double>(n);
  return each(domain::in_a_row(0, n),
              [=](std::uint64_t i) { return static_cast<double>(i) / size; });
}

inline std::vector<unsigned> sieved_primes(unsigned limit) {
  std::vector<bool> composite(limit);
  std::vector<unsigned> found;
  for (unsigned n = 2; n < limit; ++n) {
    if (composite[n]) continue;
    found.push_back(n);
    for (unsigned multiple = 2 * n; multiple < limit; multiple += n) composite[multiple] = true;
  }
  return found;
}

inline double sobol_value(std::span<const std::uint32_t> v, std::uint64_t index) {
  return sobol_word(v, index) * 0x1p-32;
}

inline Values sobol_points(unsigned dimension, std::uint64_t first, std::size_t n) {
  const auto v = sobol_directions(dimension);
  return each(domain::in_a_row(first, n), [&](std::uint64_t i) { return sobol_value(v, i); });
}

/// The expected radical inverses of a call.
struct Inverses {
  unsigned base = 2;
  std::vector<std::uint64_t> indices = {};
  std::string rule = {};  ///< the hint if no mistake explains the values
  double tolerance = inverse_tolerance;
  /// If the values are separate results: measures value k alone, and names that call.
  std::function<std::string(std::size_t)> alone = {};
};

/// The well-known mistakes that give the last value.
inline std::vector<Curve> inverse_suspects(std::span<const double> got, const Inverses& expected) {
  const auto& indices = expected.indices;
  const unsigned base = expected.base;
  std::vector<Curve> all;
  const auto suspect = [&](auto f, const Likely& hint) {
    if (!(std::abs(f(indices.back()) - got.back()) <= 1e-7)) return;
    all.push_back({each(indices, f), hint});
  };
  const auto other_index = [&](auto change, const Likely& hint) {
    suspect([=](std::uint64_t i) { return inverse(base, change(i)); }, hint);
  };
  suspect(
      [=](std::uint64_t i) {
        double size = 1;
        for (std::uint64_t rest = i; rest > 0; rest /= base) size *= base;
        return static_cast<double>(i) / size;
      },
      "the digits are not mirrored: the last digit of the index must come first "
      "after the point"_likely);
  const auto mirrored_in = [&](auto zero) {
    using Word = decltype(zero);
    for (const bool power_too : {false, true}) {  // whether the power of the base overflows, too
      suspect(
          [=](std::uint64_t i) {
            Word number = 0, power = 1;
            double size = 1;
            for (; i > 0; i /= base, size *= base, power = static_cast<Word>(power * base)) {
              number = static_cast<Word>(number * base + static_cast<Word>(i % base));
            }
            return static_cast<double>(number) / (power_too ? static_cast<double>(power) : size);
          },
          likely("the mirrored digits do not fit in {0} bits: the integer a * {1} + digit "
                 "overflows; compute with a double from the highest digit on (Horner's rule)",
                 8 * sizeof(Word), base));
    }
  };
  mirrored_in(std::uint32_t{0});
  mirrored_in(std::uint64_t{0});
  other_index([](std::uint64_t i) { return i + 1; }, "this begins one index too late"_likely);
  other_index([](std::uint64_t i) { return i & 0xffffffffu; },
              "the index was truncated to 32 bits"_likely);
  if (expected.alone) return all;
  // Columns with a wrong first index (0, the beginning of a block), or in another base.
  std::vector<std::uint64_t> firsts{0};
  for (std::uint64_t block = base; block <= indices[0]; block *= base) {
    firsts.push_back(indices[0] - indices[0] % block);
    if (block > last_index / base) break;
  }
  firsts.erase(std::unique(firsts.begin(), firsts.end()), firsts.end());
  for (const std::uint64_t first : firsts) {
    other_index([shift = indices[0] - first](std::uint64_t i) { return i - shift; },
                likely("these radical inverses start at index {}, not at {}", first, indices[0]));
  }
  for (unsigned other = 2; other < 300; ++other) {
    suspect([=](std::uint64_t i) { return inverse(other, i); },
            likely("these are in base {} instead of {}", other, base));
  }
  return all;
}

/// Every value is the radical inverse of its index. Another check tests that values are below 1;
/// here 1 counts as the largest number below it.
inline void expect_inverses(const MeasuredValues& measured, const Inverses& expected) {
  std::vector<double> got(measured.values.begin(), measured.values.end());
  std::ranges::replace(got, 1.0, 1 - half_ulp);
  const bool is_strict = expected.tolerance == inverse_tolerance;
  Comparison comparison{
      each(expected.indices, [&](std::uint64_t i) { return inverse(expected.base, i); }),
      {expected.tolerance},
      is_strict ? "the header allows an error of 4 * 2^-53; Horner's rule has at most 2 * 2^-53"
                : "far more than the 4 * 2^-53 of the header, which another check tests"};
  comparison.separate_calls = static_cast<bool>(expected.alone);
  comparison.name = [&](std::size_t k) {
    if (expected.alone) return expected.alone(k);
    return fmt::format("{}: value {}, of index {} in base {},", measured.call, k,
                       expected.indices[k], expected.base);
  };
  const MeasuredValues held{measured.call, got};
  if (!difference(held, comparison)) return pass();
  double error = 0;
  for (std::size_t i = 0; i < got.size(); ++i) {
    error = std::max(error, std::abs(got[i] - comparison.exact[i]));
  }
  comparison.suspects = inverse_suspects(got, expected);
  comparison.rule = expected.rule;
  comparison.is_tame = error > 1e-9;
  expect_each(held, comparison);
}

}  // namespace mc::checks
