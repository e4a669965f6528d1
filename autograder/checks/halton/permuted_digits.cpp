// 5.9, digit by digit: what the permutation at each position does to a value.

#include <numeric>

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_inverses.hpp"
#include "checks/halton/one_in_each.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

/// An index with one digit that is not 0.
struct Digit {
  unsigned position;
  std::uint64_t index;  ///< the digit times base^position
  double counts;        ///< base^-(position+1): what the position counts in a value
};

/// At every position that can be told from a value: where two values may be wrong by a sixteenth of
/// what it counts.
std::vector<Digit> single_digits(Rng& rng, unsigned base) {
  std::vector<Digit> digits;
  std::uint64_t power = 1;
  double counts = 1. / base;
  for (unsigned position = 0; counts > 16 * 2 * inverse_tolerance; ++position) {
    const std::uint64_t most = std::min<std::uint64_t>(base - 1, 4);
    for (std::uint64_t i = 1; i <= most; ++i) {
      const std::uint64_t digit = base < 6 ? i : 1 + rng() % (base - 1);
      if (digit <= last_index / power) digits.push_back({position, digit * power, counts});
    }
    if (power > last_index / base) break;
    power *= base;
    counts /= base;
  }
  return digits;
}

/// Some of the digits, no two at one position.
std::vector<std::size_t> some_of(Rng& rng, const std::vector<Digit>& digits) {
  std::vector<std::size_t> chosen;
  std::uint64_t sum = 0;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    const bool taken = !chosen.empty() && digits[chosen.back()].position == digits[k].position;
    if (taken || rng() % 2 == 0 || digits[k].index > last_index - sum) continue;
    sum += digits[k].index;
    chosen.push_back(k);
  }
  return chosen;
}

/// Of an index that is wrong where all before it are right.
std::string beyond_32_bits(std::uint64_t index) {
  return index <= 0xffffffffu ? "" : "; up to 2^32 all is right: are all 64 bits of an index kept?";
}

/// By how many units of its position each digit moves the value of index 0: a whole number, never
/// 0.
std::vector<double> expect_whole_moves(const std::string& call, std::span<const double> got,
                                       const std::vector<Digit>& digits, unsigned base) {
  std::vector<double> moves;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    const auto& [position, index, counts] = digits[k];
    const double move = (got[1 + k] - got[0]) / counts, whole = std::round(move);
    expect_that(
        std::abs(move - whole) * counts <= 2 * inverse_tolerance && whole != 0 &&
            std::abs(whole) < base,
        fmt::format("{}: index 0 gave {:.17g}, index {} gave {:.17g}: {:.6g} times {}^-{} more",
                    call, got[0], index, got[1 + k], move, base, position + 1),
        fmt::format("a whole multiple of {}^-{}, and not 0", base, position + 1),
        fmt::format("the indices differ at position {} only, counted from 0, and its permutation "
                    "makes two digits of them",
                    position),
        (got[0] == 0 ? "the zeros behind the last digit are digits too: permute them, to 2^-53"
         : whole == 0
             ? "this position has no permutation: indices that differ there get the same number"
             : "one permutation for each position, whatever the other digits are") +
            beyond_32_bits(index));
    moves.push_back(whole * counts);
  }
  return moves;
}

CHECK_CASE("5.9 each position has a permutation of its digits", "[5.9][points:3][main]") {
  Rng rng = check_rng();
  for (const unsigned base : {3u, 5u, 29u, 31u, 2u, 257u}) {
    const std::uint64_t seed = rng(), n = base * base;
    const std::uint64_t first = n * (rng() % 1000000);
    const auto column = MEASURE(radical_inverses_scrambled, base, first, n, {seed});
    expect_one_in_each(column.call, column.exactly(n, unit));
    // Index 0 has a permuted zero at every position; then one digit is another, then several are.
    const auto digits = single_digits(rng, base);
    std::vector<std::uint64_t> indices{0};
    for (const Digit& digit : digits) indices.push_back(digit.index);
    std::vector<std::vector<std::size_t>> several(20);
    for (auto& chosen : several) {
      chosen = some_of(rng, digits);
      std::uint64_t index = 0;
      for (const std::size_t k : chosen) index += digits[k].index;
      indices.push_back(index);
    }
    const auto measured = MEASURE(scrambled_one_by_one, base, indices, seed);
    const std::span<const double> got = measured.exactly(indices.size(), unit);
    const auto moves = expect_whole_moves(measured.call, got, digits, base);
    for (std::size_t i = 0; i < several.size(); ++i) {
      double sum = got[0];
      for (const std::size_t k : several[i]) sum += moves[k];
      const auto terms = static_cast<double>(several[i].size());
      const double value = got[1 + digits.size() + i];
      expect_within(fmt::format("{}: index {} gave {:.17g}; less what its digits do one by one",
                                measured.call, indices[1 + digits.size() + i], value),
                    value - sum, 0, 2 * inverse_tolerance + terms * half_ulp,
                    "a digit moves a value by its position alone; each value is within 4 * 2^-53",
                    {{}, "one permutation for each position, whatever the other digits are"});
    }
  }
}

}  // namespace
}  // namespace mc::checks
