// 5.9: the effect of each position's permutation on a value, and the permutations' randomness.

#include <set>

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"
#include "checks/support/constructions.hpp"

namespace mc::checks {
namespace {

const std::string one_each =
    "use one permutation per position, whatever the other digits and the other indices of the "
    "column are";
const Likely zeros_too = "the zeros after the last digit are digits, too: permute them"_likely;

/// Each of n intervals has one of n consecutive values from a multiple of n on, at the same place.
void check_bijection(const std::string& call, View x, bool is_late = false);
/// A digit moves the value of index 0 by a nonzero multiple of its unit; several, by the sum.
void check_digits(Rng& rng, unsigned base);
/// All single digits of a large base, with two seeds: different random permutations.
void check_large_base(Rng& rng, unsigned base);
/// The zeros of index 0 become random digits, down to 2^-53.
void check_zeros(Rng& rng, unsigned base);
/// Permutations in `base` at some positions, for consecutive seeds, are random.
void check_permutations(Rng& rng, unsigned base, const std::vector<unsigned>& positions,
                        std::size_t seeds);
/// A part of a column, computed separately, has the same values.
void check_part(unsigned base, std::uint64_t first, std::uint64_t count, std::uint64_t skip,
                std::uint64_t size, std::uint64_t seed);

CHECK_CASE("5.9 each position has a permutation of its digits", "[5.9][points:3][main]") {
  for (const unsigned base : {3u, 5u, 29u, 31u, 2u, 4u, 257u}) {
    const std::uint64_t n = base * base;
    for (const std::uint64_t block : {rng() % 1000, rng() % (last_index / n)}) {
      const auto column = MEASURE(radical_inverses_scrambled, base, block * n, n, {rng()});
      check_bijection(column.call, column.exactly(n, unit), block >= 1000);
    }
    check_digits(rng, base);
  }
  for (const unsigned base : {3u, 29u}) {  // unpermuted digits pass all this, too
    const auto zeros = MEASURE(radical_inverses_scrambled, base, 0, 1, domain::seeds(rng, 400));
    const View values = zeros.exactly(400, unit);
    const std::size_t different = std::set(values.begin(), values.end()).size();
    expect_that(
        different > 300, fmt::format("{}: {} different values of index 0", zeros.call, different),
        "400 seeds give more than 300 different ones",
        "its digits are infinitely many zeros, each permuted at its position", zeros_too.text,
        different <= base ? "all zeros of index 0 become the same digit: use a different "
                            "permutation for each position"_likely
                          : ""_likely);
  }
}

CHECK_CASE("5.9 permutations are random for every position and seed",
           "[5.9][needs:5.9][points:3]") {
  check_permutations(rng, 3, {0, 1, 2, 9, 25}, 2000);
  check_permutations(rng, 2, {0, 1, 2, 3, 17, 31, 32, 40}, 1000);
  check_permutations(rng, 7, {0, 13, 14, 16}, 1000);
  check_permutations(rng, 29, {0, 1, 6, 8}, 200);
  check_permutations(rng, 257, {0, 1, 2, 3}, 3);  // equal ones give repeats 256 numbers apart
  for (const unsigned base : {3u, 2u, 29u}) check_zeros(rng, base);
  for (const unsigned base : {7919u, 257u, 4099u, 40009u}) check_large_base(rng, base);
}

CHECK_CASE("5.9 neighboring seeds and all their bits", "[5.9][needs:5.9][points:1][edge]") {
  const auto of_zero = numbers_by(
      [](const Seeds& seeds) { return MEASURE(radical_inverses_scrambled, 3, 0, 1, seeds); });
  expect_all_seeds({{}, of_zero}, 3, "position", rng);
}

CHECK_CASE("5.9 a scrambled value depends only on index and seed", "[5.9][needs:5.9][points:2]") {
  const auto words = domain::words(last_index - 3000, rng);
  for (const unsigned base : {3u, 2u, 4u, 5u, 6u, 7u, 29u, 257u, 7919u, 40009u}) {
    for (int i = 0; i < 4; ++i) {
      const std::uint64_t count = 500 + rng() % 2000, skip = rng() % 400;
      const std::uint64_t first = i == 0 ? 0 : words[rng() % words.size()];
      check_part(base, first, count, skip, i < 2 ? 1 : 1 + rng() % 90, rng());
    }
    check_part(base, last_index - 599, 600, 599, 1, rng());
  }
  for (const std::uint64_t n : domain::sizes(5000, rng)) {
    const unsigned base = n % 2 == 0 ? 2 : 5;
    check_part(base, rng() % 70, 5100, rng() % 100, n, rng());
  }
  for (int bit = 5; bit < 64; ++bit) {  // below and above a power of two
    check_part(bit % 2 == 0 ? 3 : 2, (std::uint64_t{1} << bit) - 30, 60, 20 + rng() % 20, 20,
               rng());
  }
  check_part(7, 7, 20, 3, 0, 1);
}

CHECK_CASE("5.9 bases up to 2^16", "[5.9][needs:5.9][points:0.5][edge]") {
  for (const unsigned base : {65535u, 65536u}) {
    check_large_base(rng, base);
    check_part(base, rng() >> (rng() % 20), 100, 7, 13, rng());
    check_part(base, last_index - 99, 100, 99, 1, rng());
  }
}

void check_bijection(const std::string& call, View x, bool is_late) {
  const auto parts = static_cast<double>(x.size());
  const double least = *std::ranges::min_element(x);
  std::vector<int> points(x.size());
  for (const double value : x) {
    const double part = (value - least) * parts;
    const auto whole = static_cast<std::size_t>(std::llround(part));
    if (std::abs(part - std::round(part)) < 1e-6 && whole < x.size()) ++points[whole];
  }
  expect_that(
      least < 1 / parts + 1e-9 && std::ranges::all_of(points, [](int k) { return k == 1; }),
      fmt::format("{}: not one value in each of {} intervals", call, parts),
      fmt::format("one value in each of {} intervals, all at the same place in their interval",
                  parts),
      "the last digits have all combinations, and so do their permutations",
      "a permutation is a bijection; use one for each position, not for each digit before",
      is_late ? "the first indices are right: keep all 64 bits of an index"_likely : ""_likely);
}

/// An index with one digit that is not 0.
struct Digit {
  std::uint64_t index;  ///< the digit times base^position
  unsigned position;
  double counts;  ///< base^-(position+1): the unit of the position
};

/// Digits at every position whose unit is at least 16 times the error of two values.
std::vector<Digit> single_digits(Rng& rng, unsigned base) {
  std::vector<Digit> digits;
  std::uint64_t power = 1;
  double counts = 1. / base;
  for (unsigned position = 0; counts > 16 * 2 * inverse_tolerance; ++position) {
    const std::uint64_t most = std::min<std::uint64_t>(base - 1, 4);
    for (std::uint64_t i = 1; i <= most; ++i) {
      const std::uint64_t digit = base < 6 ? i : 1 + rng() % (base - 1);
      if (digit <= last_index / power) digits.push_back({digit * power, position, counts});
    }
    if (power > last_index / base) break;
    power *= base;
    counts /= base;
  }
  return digits;
}

void check_digits(Rng& rng, unsigned base) {
  const auto digits = single_digits(rng, base);
  std::vector<std::uint64_t> indices{0};
  for (const Digit& digit : digits) indices.push_back(digit.index);
  std::vector<std::vector<std::size_t>> several(20);  // digits at different positions
  for (auto& chosen : several) {
    std::uint64_t sum = 0;
    for (std::size_t k = 0; k < digits.size(); ++k) {
      const bool is_taken = !chosen.empty() && digits[chosen.back()].position == digits[k].position;
      if (is_taken || rng() % 2 == 0 || digits[k].index > last_index - sum) continue;
      sum += digits[k].index;
      chosen.push_back(k);
    }
    indices.push_back(sum);
  }
  const std::uint64_t seed = fresh_seed(rng);
  const auto measured = MEASURE(scrambled_one_by_one, base, indices, {seed});
  const View got = measured.exactly(indices.size(), unit);
  Values moves;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    const auto& [index, position, counts] = digits[k];
    const double move = (got[1 + k] - got[0]) / counts, whole = std::round(move);
    const bool holds = std::abs(move - whole) * counts <= 2 * inverse_tolerance && whole != 0 &&
                       std::abs(whole) < base;
    const std::string call =
        holds ? "" : MEASURE(scrambled_one_by_one, base, {0, index}, {seed}).call;
    expect_that(
        holds,
        fmt::format("{}: index 0 gave {:.17g}, index {} gave {:.17g}, {:.6g} times {}^-{} more",
                    call, got[0], index, got[1 + k], move, base, position + 1),
        fmt::format("a nonzero integer times {}^-{}", base, position + 1),
        fmt::format("the permutation of position {} (from 0) gives the indices different digits",
                    position),
        one_each,
        got[0] == 0  ? zeros_too
        : whole == 0 ? "this position has no permutation: indices that differ there get "
                       "the same value"_likely
                     : ""_likely);
    moves.push_back(whole * counts);
  }
  for (std::size_t i = 0; i < several.size(); ++i) {
    double sum = got[0];
    for (const std::size_t k : several[i]) sum += moves[k];
    const std::size_t at = 1 + digits.size() + i;
    const double most = 2 * inverse_tolerance + static_cast<double>(several[i].size()) * half_ulp;
    expect_that(std::abs(got[at] - sum) <= most,
                fmt::format("{}: index {} gave {:.17g}", measured.call, indices[at], got[at]),
                fmt::format("{:.17g} ± {:.3g}, the sum of its digits' effects", sum, most),
                "a digit's effect depends only on its position; values have errors of 4 * 2^-53",
                one_each);
  }
}

void check_large_base(Rng& rng, unsigned base) {
  const auto measured = MEASURE(radical_inverses_scrambled, base, 0, base, {rng(), rng()});
  const SampleSets got = sets_from_columns(measured, base, 1, 2);
  Uniforms choices{got.call};
  for (std::size_t set = 0; set < 2; ++set) {  // equal ones are half of the list apart
    check_bijection(got.call, got.column(set, 0));
    std::vector<std::size_t> digits;
    for (const double x : got.column(set, 0)) digits.push_back(*stratum_of(x, base));
    append(choices.values, uniforms_of_permutation(digits, rng));
  }
  expect_independent_uniforms(
      choices, {.words = fmt::format("a random permutation of {} digits", base),
                .rule = "all permutations must be equally likely, and depend on the seed"});
}

void check_zeros(Rng& rng, unsigned base) {
  const auto zeros = MEASURE(radical_inverses_scrambled, base, 0, 1, domain::seeds(rng, 400));
  Values values = zeros.exactly(400, unit);
  const Randomness claim{
      .words = "the scrambled value of index 0 is uniform",
      .rule = "use a random digit for each of the zeros of index 0, down to 2^-53"};
  expect_independent_uniforms({zeros.call, 1, values}, claim, true);
  // The digits from the 40th bit on, to 6 bits: the last digits are rounded.
  const double power = std::pow(base, std::ceil(40 / std::log2(base)));
  for (double& x : values) x = std::min(x * power - std::floor(x * power), 1 - half_ulp);
  expect_independent_uniforms({zeros.call, 1, values, 6}, claim, true);
}

void check_permutations(Rng& rng, unsigned base, const std::vector<unsigned>& positions,
                        std::size_t seeds) {
  std::vector<std::uint64_t> indices{0};
  for (const unsigned position : positions) {
    std::uint64_t power = 1;
    for (unsigned k = 0; k < position; ++k) power *= base;
    for (unsigned digit = 1; digit < base; ++digit) indices.push_back(digit * power);
  }
  const SeededConstruction scrambled{
      {},
      numbers_by(
          [&](const Seeds& part) { return MEASURE(scrambled_one_by_one, base, indices, part); },
          indices.size()),
      2000 / indices.size()};
  const auto [call, per_seed, got, bits, name] =
      numbers_of(scrambled, domain::in_a_row(rng() >> 1, seeds));
  Uniforms numbers{call, positions.size() * (base - 1)};
  numbers.name = [=](std::size_t k) {
    return fmt::format("choice {} of the permutation at position {}", k % (base - 1),
                       positions[k / (base - 1)]);
  };
  std::vector<std::size_t> orders;
  for (std::size_t r = 0; r < seeds; ++r) {
    for (std::size_t p = 0; p < positions.size(); ++p) {
      Values row{got[r * per_seed]};  // of the digits 0 … base - 1 there
      append(row, View(got).subspan(r * per_seed + 1 + p * (base - 1), base - 1));
      std::vector<std::size_t> order(base);
      for (std::size_t k = 0; k < base; ++k) {
        order[k] = static_cast<std::size_t>(
            std::ranges::count_if(row, [&](double x) { return x < row[k]; }));
      }
      append(numbers.values, uniforms_of_permutation(order, rng));
      append(orders, order);
    }
  }
  expect_independent_uniforms(
      numbers,
      {.words = fmt::format("the permutations of {} digits are random, for each position and seed",
                            base),
       .rule = "use a random permutation for each position, from a hash of seed and position",
       .explain = [&]() -> Likely {
         // The orders at position 0 for a seed, and at position 1 for the seed before it.
         const std::size_t row = positions.size() * base;
         const auto order_at = [&](std::size_t r, std::size_t p) {
           return std::span(orders).subspan(r * row + p * base, base);
         };
         bool is_shifted = true;
         for (std::size_t r = 0; r + 1 < seeds; ++r) {
           is_shifted = is_shifted && std::ranges::equal(order_at(r + 1, 0), order_at(r, 1));
         }
         if (is_shifted) {
           return "position 1 of a seed has the permutation of position 0 of the next seed: mix "
                  "both by a hash, do not add them"_likely;
         }
         return base == 3 ? shuffle_hint(orders, 3) : ""_likely;
       }});
}

void check_part(unsigned base, std::uint64_t first, std::uint64_t count, std::uint64_t skip,
                std::uint64_t size, std::uint64_t seed) {
  const auto whole = MEASURE(radical_inverses_scrambled, base, first, count, {seed});
  const auto part = MEASURE(radical_inverses_scrambled, base, first + skip, size, {seed});
  const View exact = View(whole.exactly(count, unit)).subspan(skip, size);
  expect_each(
      {part.call, part.exactly(size, unit)},
      {.exact = {exact.begin(), exact.end()},
       .because = "a function of base, index and seed only: the same indices as in " + whole.call,
       .rule =
           "a value must not depend on where its column begins and ends, not even by rounding"});
}

}  // namespace
}  // namespace mc::checks
