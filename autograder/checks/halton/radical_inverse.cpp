// 5.1, 5.2: radical inverses of single indices and of columns, compared with 106-bit values.

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"

namespace mc::checks {
namespace {

using Indices = std::vector<std::uint64_t>;

/// Compares radical inverses of single indices, in any order.
void check_indices(Inverses expected);
/// Indices for which adding the largest terms first exceeds the tolerance.
Indices hard_indices(Rng& rng, unsigned base, std::size_t count);
void check_column(unsigned base, std::uint64_t first, std::uint64_t count, const std::string& rule);
/// An index that 5.1 rounds up to 1 costs points there, not in a loop over it.
void check_below_1(unsigned base, std::uint64_t first, std::uint64_t count);

CHECK_CASE("5.1 the radical inverse mirrors the digits of the index", "[5.1][points:8][main]") {
  // Wider than the header's bound: 15 digits added in any order. Another check tests the order.
  constexpr double room = 15 * half_ulp;
  const std::string rule =
      "multiply digit k of the index, from the last with k = 0, by base^-(k+1)";
  check_indices({2, {74, 6, 1, 2, 3}, rule, room});  // the lecture's example: 74 gives 41/128
  for (const unsigned base : {3u, 2u, 5u, 7u, 10u, 29u}) {
    Indices indices(80);
    for (auto& index : indices) index = rng() % (base * base * base);
    std::iota(indices.begin() + 40, indices.end(), 0);
    check_indices({base, indices, rule, room});
  }
}

CHECK_CASE("5.1 every index of 64 bits in every base", "[5.1][points:5]") {
  constexpr double room = 64 * half_ulp;  // 64 digits in any order
  for (unsigned base :
       {3u,   2u,    5u,     7u,     11u,    13u,      17u,         19u,         23u, 29u, 31u,
        257u, 7919u, 65535u, 65536u, 65537u, 1u << 31, 4294967291u, 4294967295u, 0u,  1u}) {
    if (base < 2) base = 2 + static_cast<unsigned>(rng() % 4294967294u);
    Indices indices = domain::words(last_index, rng);
    for (std::uint64_t power = base; power <= last_index / base; power *= base) {
      indices.insert(indices.end(), {power, power - 1, power + rng() % power});
    }
    check_indices(
        {base, indices,
         "divide the 64-bit index by the base until it is 0, without powers or logarithms", room});
  }
}

CHECK_CASE("5.1 rounding errors do not add up", "[5.1][points:3]") {
  for (const unsigned base : {3u, 5u, 6u, 7u, 2u, 29u}) {
    Indices indices = base < 3 || base > 7 ? Indices{} : hard_indices(rng, base, 3);
    indices.push_back(2419277);  // the handout's example in base 3
    for (int i = 0; i < 100; ++i) indices.push_back(rng());
    check_indices({base, indices,
                   "each sum and each power of 1 / base is rounded: divide by the base "
                   "once per digit, and add the smallest terms first"});
  }
}

CHECK_CASE("5.1 the radical inverse is below 1", "[5.1][points:3][edge]") {
  for (const unsigned base : {2u, 3u, 5u, 7u, 11u, 13u, 29u, 31u, 7919u, 65537u, 4294967295u}) {
    Indices ones{last_index};  // base^k - 1: every digit the largest
    for (std::uint64_t index = base - 1;; index = index * base + (base - 1)) {
      ones.push_back(index);
      if (index > (last_index - (base - 1)) / base) break;
    }
    MEASURE(radical_inverse, base, ones).exactly(ones.size(), unit);
  }
}

const std::string as_single = "each value must equal that of 5.1: do not accumulate errors";

CHECK_CASE("5.2 a column has the radical inverses of 0 1 2 and so on",
           "[5.2][stretch][needs:5.1][main]") {
  const auto sizes = domain::sizes(65537, rng);
  for (const unsigned base :
       {3u, 2u, 5u, 16u, 29u, 31u, 131u, 256u, 1021u, 1024u, 1031u, 7919u, 65537u, 4294967295u}) {
    check_column(base, 0, 4096 + rng() % 100, as_single);
    check_column(base, 0, sizes[rng() % sizes.size()], as_single);
  }
  for (const std::uint64_t count : sizes) check_column(count % 2 == 0 ? 2 : 3, 0, count, as_single);
  check_column(5, 0, 0, "");
}

CHECK_CASE("5.2 a column may begin anywhere", "[5.2][stretch][needs:5.1]") {
  const std::string rule = "a value depends on all 64 bits of its index, not on its place";
  const auto words = domain::words(last_index - 3000, rng);
  for (const unsigned base : {3u, 2u, 5u, 7u, 31u, 257u, 7919u, 65537u, 4294967291u}) {
    // From the last index of a block on: the block's beginning, the previous index and 0 differ.
    const std::uint64_t block = base < 100 ? base * base : base;
    std::uint64_t power = base;
    while (power < 1000000000) power *= base;
    check_column(base, 2 * block - 1 + block * (rng() % 50), 300 + rng() % 1500, rule);
    check_column(base, power - 1 - rng() % 300, 1000, rule);  // nine digits change at once
    check_column(base, (rng() >> 20) | (std::uint64_t{1} << 43), 700, rule);
    for (int i = 0; i < 3; ++i) {
      check_column(base, words[rng() % words.size()], 1 + rng() % 2000, rule);
    }
    check_column(base, last_index - 599, 600, rule);
    check_column(base, last_index, 1, rule);
  }
  // A column that begins where one in another base ended; replayed in one process.
  for (const unsigned base : {3u, 2u, 3u}) check_column(base, base == 2 ? 1000 : 1300, 300, rule);
  for (const std::uint64_t first : {std::uint64_t{5}, last_index}) check_column(2, first, 0, "");
}

CHECK_CASE("5.2 every value of a column is below 1", "[5.2][stretch][needs:5.1][edge]") {
  for (const unsigned base : {2u, 5u, 11u, 29u, 31u}) {
    for (std::uint64_t power = base; power <= last_index / base; power *= base) {
      if (power >> 50 != 0) check_below_1(base, power - 1050, 1050);
    }
  }
  check_below_1(2, last_index - 2047, 2048);
}

void check_indices(Inverses expected) {
  std::ranges::sort(expected.indices);  // the smallest that is wrong comes first
  const auto got = MEASURE(radical_inverse, expected.base, expected.indices);
  const View values = got.exactly(expected.indices.size(), any_number);
  expected.alone = [&](std::size_t k) {
    return MEASURE(radical_inverse, expected.base, {expected.indices[k]}).call;
  };
  expect_inverses({got.call, values}, expected);
}

/// Of 200,000 random indices, these are 136 in base 3, 464 in base 5, 724 in base 6, 1,124 in base
/// 7, and none in bases 29 and 31.
Indices hard_indices(Rng& rng, unsigned base, std::size_t count) {
  Indices hard;
  while (hard.size() < count) {
    const std::uint64_t index = rng();
    double sum = 0, part = 1;
    for (std::uint64_t rest = index; rest > 0; rest /= base) {
      part /= base;
      sum += part * static_cast<double>(rest % base);
    }
    if (std::abs(sum - inverse(base, index)) > inverse_tolerance) hard.push_back(index);
  }
  return hard;
}

void check_column(unsigned base, std::uint64_t first, std::uint64_t count,
                  const std::string& rule) {
  const auto got = MEASURE(radical_inverses, base, first, count);
  expect_inverses({got.call, got.exactly(count, any_number)},
                  {base, domain::in_a_row(first, count), rule});
}

void check_below_1(unsigned base, std::uint64_t first, std::uint64_t count) {
  const auto one_by_one = MEASURE(radical_inverse, base, domain::in_a_row(first, count));
  const View single = one_by_one.exactly(count, any_number);
  const auto column = MEASURE(radical_inverses, base, first, count);
  if (std::ranges::equal(single, column.exactly(count, any_number))) return pass();
  column.exactly(count, unit);
}

}  // namespace
}  // namespace mc::checks
