// Task 2.8: numbers by the block.

#include <algorithm>
#include <numeric>

#include "checks/independent/functions.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/domain.hpp"

namespace mc::checks {
namespace {

using Sizes64 = std::vector<std::uint64_t>;

const std::string from_rng = "take the numbers from rng, and from nowhere else";
const std::string same_place = "do two calls, or two lanes, begin in the same place?";
const std::string in_step =
    "do lanes run in step, or begin with equal numbers? Lanes want states that have nothing in "
    "common, not seed, seed + 1, seed + 2; and a call leaves the generator where the next begins";

/// Calls for so many numbers, one after the other, in a span of NaNs: as many numbers in [0, 1).
Uniforms filled(std::uint64_t seed, const Sizes64& sizes) {
  const std::size_t total = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  const auto got = MEASURE(uniforms, seed, sizes, nan);
  const Values& all = got.exactly(total, any_number);
  const auto at = static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [](double u) { return std::isnan(u); }) - all.begin());
  if (at < total) {
    const auto again = MEASURE(uniforms, seed, sizes, 5.0);
    const double now = again.exactly(total, any_number)[at];
    expect_that(false, fmt::format("{}: number {} is NaN", got.call, at),
                "numbers in [0, 1), all of them", "a span of any size is to be filled",
                now == 5 ? "NaN stood there before: it was not filled. The last, shorter block?"
                : now > 5 && now < 6 ? "the number is added to what stood there: = in place of +="
                                     : "is something 0/0?");
  }
  return {got.call, 1, got.exactly(total, unit)};
}

/// The numbers of `calls` calls, from one generator or from a generator for each seed: a replicate
/// of the first `positions` numbers of each call.
Uniforms beginnings(Uniforms all, std::size_t size, std::size_t positions) {
  Uniforms first{all.call, positions};
  for (std::size_t call = 0; call < all.values.size() / size; ++call) {
    const auto begin = all.values.begin() + static_cast<std::ptrdiff_t>(call * size);
    first.values.insert(first.values.end(), begin, begin + static_cast<std::ptrdiff_t>(positions));
  }
  first.name = [](std::size_t i) { return fmt::format("number {} of a call", i); };
  return first;
}

/// Calls begin with numbers that never came before: of N numbers with 53 bits, N^2 / 2^54 pairs are
/// equal by chance: 6e-6 for N = 320,000, so that two are as good as impossible (2e-11). A
/// generator of one's own that is seeded by 32 bits begins in the same place for 12 pairs, and with
/// one pair or none once in 12,000 runs.
void judge_beginnings(Rng& rng) {
  Values first;
  std::string call;
  for (int i = 0; i < 8; ++i) {
    const auto got = MEASURE(first_uniforms, rng(), 130 + rng() % 50, 40'000);
    call = got.call;
    const Values& here = got.exactly(40'000, unit);
    first.insert(first.end(), here.begin(), here.end());
  }
  std::sort(first.begin(), first.end());
  std::size_t equal = 0;
  for (std::size_t i = 1; i < first.size(); ++i) equal += first[i] == first[i - 1] ? 1 : 0;
  expect_that(equal < 2, fmt::format("{} and seven such: {} numbers came twice", call, equal),
              "none, or one", "320,000 numbers of 53 bits each are all different",
              "does each call begin with a state of its own, of 64 bits at least? A generator that "
              "one number of 32 bits seeds has only 2^32 places to begin");
}

CHECK_CASE("2.8 a span of any size is filled with new numbers",
           "[2.8][points:5][needs:2.1][main]") {
  Rng rng = check_rng();
  Sizes64 sizes = domain::sizes(4097, rng);
  sizes.push_back(0);
  const Uniforms one = filled(rng(), sizes), other = filled(rng(), sizes);
  expect_independent_uniforms(side_by_side(one, other), {"the numbers of 2.8 from two seeds", alpha,
                                                         in_step, from_rng, from_rng});
  expect_independent_uniforms(one, {"the numbers of 2.8", alpha, in_step, same_place});
  judge_beginnings(rng);
}

CHECK_CASE("2.8 a call depends on its generator alone", "[2.8][points:1][edge][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t seed = rng(), another = rng(), size = 1024;
  const auto got = MEASURE(uniforms_in_turn, {seed, another, seed}, size);
  const auto alone = MEASURE(uniforms_in_turn, {another}, size);
  const auto u = std::span(got.exactly(3 * size, unit));
  const std::string because = "the generator it is given is its only source of randomness";
  const std::string hint =
      "no generator of your own that stays alive between calls: nothing static";
  expect_that(std::ranges::equal(u.last(size), u.first(size)),
              got.call + ": the third generator, equal to the first, gave other numbers",
              "the same numbers", because, hint);
  expect_that(std::ranges::equal(u.subspan(size, size), alone.exactly(size, unit)),
              got.call + ": the second generator gave other numbers than it gives alone",
              "the same numbers", because, hint);
}

CHECK_CASE("2.8 a generator of one word", "[2.8][points:1][edge][needs:2.1]") {
  Rng rng = check_rng();
  for (const std::uint64_t word : domain::constant_words(rng)) {
    MEASURE(uniforms_constant, word, 1024).exactly(1024, unit);
  }
}

/// The last 13 bits of numbers are independent, too.
void judge_last_bits(const Uniforms& numbers, Rng& rng) {
  Uniforms last{numbers.call + ", the last 13 of 53 bits", 1};
  for (const double u : numbers.values) {
    last.values.push_back(fill_cell(bits_of(u) % 8192, 8192, rng));
  }
  expect_independent_uniforms(
      last, {"the last bits of many numbers", alpha,
             "53 random bits, also in the last places: the low bits of a linear congruential "
             "generator repeat soon, and 52 bits in a mantissa are one too few"});
}

CHECK_CASE("2.8 many numbers of a call are independent", "[2.8][points:2][needs:2.1]") {
  Rng rng = check_rng();
  Uniforms many = filled(rng(), {131'072, 65'537});
  many.values.resize(196'608);
  many.positions = 32;
  expect_independent_uniforms(many,
                              {"many numbers of a call", alpha, in_step, same_place, in_step});
  judge_last_bits(many, rng);
}

CHECK_CASE("2.8 the first numbers of a call are independent", "[2.8][points:2][needs:2.1]") {
  Rng rng = check_rng();
  // Lanes whose states differ by little give nearly the same at first. From one generator, and from
  // seeds that differ by little.
  const std::size_t size = 160, positions = 40, calls = 1500;
  Sizes64 seeds = domain::seeds_in_a_row(rng() >> 1, calls);
  for (const std::uint64_t seed : domain::seeds_by_bit(rng)) seeds.push_back(seed);
  const auto in_turn = MEASURE(uniforms_in_turn, seeds, size);
  const Uniforms by_seed{in_turn.call, 1, in_turn.exactly(seeds.size() * size, unit)};
  expect_independent_uniforms(
      beginnings(filled(rng(), Sizes64(calls, size)), size, positions),
      {"the first numbers of calls from one generator", alpha, in_step, in_step, in_step});
  expect_independent_uniforms(
      beginnings(by_seed, size, positions),
      {"the first numbers of calls from neighboring seeds", alpha, in_step, in_step, in_step});
  for (const std::uint64_t few : {5u, 37u}) {
    const Uniforms all = filled(rng(), Sizes64(calls, few));
    expect_independent_uniforms(beginnings(all, few, few), {"the numbers of short calls", alpha,
                                                            in_step, same_place, in_step});
    judge_last_bits(all, rng);
  }
}

}  // namespace
}  // namespace mc::checks
