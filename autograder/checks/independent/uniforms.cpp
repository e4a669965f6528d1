// 2.1, 2.8: a number from a word; many numbers at once.

#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

using Words = std::vector<std::uint64_t>;

void judge_words(const Words& words);

CHECK_CASE("2.1 the upper 53 bits of a word become a number", "[2.1][points:3][main]") {
  Words words;
  for (int i = 0; i < 1000; ++i) words.push_back(rng() >> (rng() % 53));
  judge_words(words);
}

CHECK_CASE("2.1 words at both ends and powers of two", "[2.1][points:2][edge]") {
  Words words = domain::words(~std::uint64_t{0}, rng);
  for (std::uint64_t below = 0; below < 4096; below += 61) words.push_back(~below);
  judge_words(words);
}

using Sizes64 = std::vector<std::uint64_t>;

const Likely same_place =
    "numbers occur again: two calls or two lanes begin with the same state, or with states that "
    "follow each other"_likely;
const std::string in_step =
    "all numbers are independent: in one call and between calls, in one lane and between lanes "
    "(whose states must be unrelated, not seed, seed + 1, seed + 2)";

Uniforms filled(std::uint64_t seed, const Sizes64& sizes);
Uniforms beginnings(Uniforms all, std::size_t size, std::size_t positions);
void judge_beginnings(Rng& rng);
void judge_last_bits(const Uniforms& numbers, Rng& rng);
void judge_recurrences(const Uniforms& all);

CHECK_CASE("2.8 a span of any size is filled with new numbers", "[2.8][stretch][needs:2.1][main]") {
  Sizes64 sizes = domain::sizes(4097, rng);
  sizes.push_back(0);
  const Uniforms one = filled(rng(), sizes), other = filled(rng(), sizes);
  const auto of_any_seed = [&] {
    return common_values(one.values, other.values) > 2 ? from_rng : Likely();
  };
  expect_independent_uniforms(one, {.words = "the numbers of 2.8",
                                    .rule = in_step,
                                    .repeated = same_place,
                                    .explain = of_any_seed});
  expect_independent_uniforms(side_by_side(one, other), {"the numbers of 2.8 from two seeds", alpha,
                                                         in_step, from_rng, from_rng});
  judge_beginnings(rng);
}

CHECK_CASE("2.8 a generator of one word", "[2.8][stretch][edge][needs:2.1]") {
  for (const std::uint64_t word : domain::constant_words(rng)) {
    MEASURE(uniforms_constant, word, 1024).exactly(1024, unit);
  }
}

CHECK_CASE("2.8 many numbers of a call are independent", "[2.8][stretch][needs:2.1]") {
  Uniforms many = filled(rng(), {131'072, 65'537});
  many.values.resize(196'608);
  judge_recurrences(many);
  many.positions = 32;
  expect_independent_uniforms(many, {"many numbers of a call", alpha, in_step, same_place});
  judge_last_bits(many, rng);
}

CHECK_CASE("2.8 the first numbers of a call are independent", "[2.8][stretch][needs:2.1]") {
  // Lanes with similar states begin with similar numbers: with one generator, and similar seeds.
  const std::size_t size = 160, positions = 40, calls = 1500;
  Sizes64 seeds = domain::in_a_row(rng() >> 1, calls);
  for (const std::uint64_t seed : domain::seeds_by_bit(rng)) seeds.push_back(seed);
  const auto in_turn = MEASURE(uniforms_in_turn, seeds, size);
  const Uniforms by_seed{in_turn.call, 1, in_turn.exactly(seeds.size() * size, unit)};
  expect_independent_uniforms(beginnings(filled(rng(), Sizes64(calls, size)), size, positions),
                              {"the first numbers of calls from one generator", alpha, in_step});
  expect_independent_uniforms(
      beginnings(by_seed, size, positions),
      {"the first numbers of calls from neighboring seeds", alpha, in_step});
  for (const std::uint64_t few : {std::uint64_t{5}, std::uint64_t{37}, 100 + rng() % 28}) {
    const Uniforms all = filled(rng(), Sizes64(calls, few));
    expect_independent_uniforms(beginnings(all, few, few),
                                {"the numbers of short calls", alpha, in_step, same_place});
    judge_last_bits(all, rng);
  }
}

// What the cases above use ------------------------------------------------------------------------

double as_double(std::uint64_t bits) {
  return static_cast<double>(bits);
}

void judge_words(const Words& words) {
  using Word = std::uint64_t;
  const auto got = MEASURE(to_unit, words);
  Comparison exact{each(words, [](Word w) { return as_double(w >> 11) * 0x1p-53; })};
  exact.because =
      "a shift, a conversion of 53 bits and a multiplication by a power of two are exact; the "
      "largest result is (2^53 - 1) / 2^53, so that log(1 - u) is finite";
  exact.rule = "floor(bits / 2^11) times 2^-53; both steps are exact";
  exact.separate_calls = true;
  exact.name = [&](std::size_t i) { return fmt::format("to_unit({})", words[i]); };
  exact.suspects = {
      {each(words, [](Word w) { return as_double(w) * 0x1p-64; }),
       "a word has 64 bits and a double 53: bits / 2^64 is rounded; shift out "
       "11 bits first"_likely},
      {each(words, [](Word w) { return as_double(w >> 11) / (0x1p53 - 1); }),
       "dividing by 2^53 - 1 makes 1 a possible result: divide by 2^53"_likely},
      {each(words, [](Word w) { return as_double(w & 0xffffffffu) * 0x1p-32; }),
       "these are the lower 32 bits: the word was converted to a 32-bit integer"_likely}};
  expect_each({got.call, got.exactly(words.size(), any_number)}, exact);
}

/// Consecutive calls fill spans of these sizes, which contain NaN before, with numbers in [0, 1).
Uniforms filled(std::uint64_t seed, const Sizes64& sizes) {
  const std::size_t total = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const auto got = MEASURE(uniforms, seed, sizes, nan);
  const Values& all = got.exactly(total, any_number);
  const auto at = static_cast<std::size_t>(
      std::ranges::find_if(all, [](double u) { return std::isnan(u); }) - all.begin());
  if (at < total) {
    const auto again = MEASURE(uniforms, seed, sizes, 5.0);
    const double now = again.exactly(total, any_number)[at];
    const bool is_sum = now > 5 && now < 6;
    fail(Failure{fmt::format("{}: number {} is NaN", got.call, at),
                 "numbers in [0, 1), all of them", "the function fills a span of any size",
                 is_sum
                     ? "the number is added to the previous contents: write = instead of +="_likely
                     : ""_likely,
                 "every number must be written, also those of a shorter last block"});
  }
  return {got.call, 1, got.exactly(total, unit)};
}

/// The first `positions` numbers of each call, as one replicate per call.
Uniforms beginnings(Uniforms all, std::size_t size, std::size_t positions) {
  all.positions = size;
  all.name = [](std::size_t i) { return fmt::format("number {} of a call", i); };
  std::vector<std::size_t> first(positions);
  std::iota(first.begin(), first.end(), 0);
  return some_of(all, first);
}

/// Calls begin with new numbers: with 32-bit states, 19 pairs of 400,000 calls would be equal.
void judge_beginnings(Rng& rng) {
  Uniforms first;
  for (int i = 0; i < 10; ++i) {
    const auto got = MEASURE(first_uniforms, rng(), 130 + rng() % 50, 40'000);
    append(first.values, got.exactly(40'000, unit));
    first.call = got.call;
  }
  const std::string few_states =
      "a call needs a 64-bit state: a 32-bit seed has only 2^32 initial states";
  expect_independent_uniforms(first, {"the first numbers of calls", alpha, few_states});
}

/// The last 13 bits of the numbers, and the last 4, are independent, too. (In a linear congruential
/// generator, the bit with the period 2^k is the opposite 2^(k-1) numbers later.)
void judge_last_bits(const Uniforms& numbers, Rng& rng) {
  for (const unsigned bits : {13u, 4u}) {
    Uniforms last{fmt::format("{}, the last {} of 53 bits", numbers.call, bits), 1};
    const std::uint64_t cells = std::uint64_t{1} << bits;
    for (const double u : numbers.values) {
      last.values.push_back(fill_cell(bits_of(u) % cells, cells, rng));
    }
    expect_independent_uniforms(
        last, {"the last bits of many numbers", alpha / 2,
               "all 53 bits of every number must be random, also of the last ones of a call: the "
               "low bits of a linear congruential generator have short periods, a sum of two "
               "numbers is rounded, and a mantissa stores only 52 bits"});
  }
}

/// No number is the sum, the difference or the exclusive or of two of the 256 before it, as in a
/// lagged Fibonacci generator (Knuth, volume 2, 3.2.2). By chance, one of 130,560 combinations
/// gives four numbers in a row, to 28 bits, with probability 2^-95.
void judge_recurrences(const Uniforms& all) {
  const auto word = [&](std::size_t k) { return bits_of(all.values[k]) << 11; };
  for (std::size_t far = 2; far <= 256; ++far) {
    for (std::size_t near = 1; near < far; ++near) {
      std::array<bool, 4> fits{true, true, true, true};
      for (std::size_t k = 1000; k < 1004; ++k) {
        const std::uint64_t x = word(k - near), y = word(k - far);
        const std::uint64_t made[] = {x + y, x - y, y - x, x ^ y};
        for (std::size_t way = 0; way < 4; ++way) {
          fits[way] &= (word(k) - made[way] + (std::uint64_t{1} << 35)) >> 36 == 0;
        }
      }
      if (fits == std::array<bool, 4>{}) continue;
      fail(Failure{fmt::format("{}: u[k] is a sum, a difference or an exclusive or of u[k-{}] and "
                               "u[k-{}]",
                               all.call, near, far),
                   "independent numbers", "", "this is a lagged Fibonacci generator"_likely});
    }
  }
}

}  // namespace
}  // namespace mc::checks
