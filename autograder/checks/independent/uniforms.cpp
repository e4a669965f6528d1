// Task 2.8: numbers by the block.

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "checks/independent/traces.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

using Sizes64 = std::vector<std::uint64_t>;

std::size_t total(const Sizes64& sizes) {
  return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
}

/// Calls for so many numbers, one after the other, in a span of NaNs: as many numbers in [0, 1).
class Filled {
 public:
  Filled(std::uint64_t seed, const Sizes64& sizes)
      : measured_(MEASURE(uniforms, seed, sizes, nan)) {
    const Values* const all = measured_.if_exactly(total(sizes), any_number);
    const auto nan_at = all == nullptr ? Values::const_iterator{}
                                       : std::find_if(all->begin(), all->end(),
                                                      [](double u) { return std::isnan(u); });
    if (all != nullptr && nan_at != all->end()) {
      expect_that(false, fmt::format("{}: number {} is NaN", call(), nan_at - all->begin()),
                  "numbers in [0, 1), all of them", "a span of any size is to be filled",
                  why_nan(seed, sizes, static_cast<std::size_t>(nan_at - all->begin())));
    }
    measured_.exactly(total(sizes), unit);
  }

  const std::string& call() const { return measured_.call; }
  const Values& numbers() const { return *measured_.if_at_most(most); }

 private:
  static constexpr std::size_t most = std::size_t{1} << 21;

  /// What became of a number there that was 5 before.
  static std::string why_nan(std::uint64_t seed, const Sizes64& sizes, std::size_t at) {
    const auto again = TRY_MEASURE(uniforms, seed, sizes, 5.0);
    const Values* const all = again ? again->if_exactly(total(sizes), any_number) : nullptr;
    const double now = all == nullptr ? nan : (*all)[at];
    if (now == 5) return "NaN stood there before: it was not filled. The last, shorter block?";
    if (now > 5 && now < 6) return "the number is added to what stood there: = in place of +=";
    return "is something 0/0?";
  }

  Measured<Values> measured_;
};

/// How many bits behind the point the longest of the numbers has.
unsigned bits_of(const Values& numbers) {
  unsigned bits = 0;
  for (const double u : numbers) {
    while (bits < 53 && std::ldexp(u, static_cast<int>(bits)) !=
                            std::floor(std::ldexp(u, static_cast<int>(bits))))
      ++bits;
  }
  return bits;
}

/// Of N numbers with 53 bits, N^2 / 2^54 pairs are equal by chance: 9e-6 for N = 4e5, so that three
/// are as good as impossible (1e-16). With 32 bits there would be 19.
void expect_different(Rng& rng) {
  const Sizes64 sizes{200000, 100000, 100000};
  const Filled many(rng(), sizes);
  const Values& u = many.numbers();
  std::vector<std::size_t> order(u.size()), repeated;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return u[a] < u[b]; });
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (u[order[i]] == u[order[i - 1]]) repeated.push_back(std::max(order[i], order[i - 1]));
  }
  if (repeated.size() < 3) return pass();
  const auto at_beginning = [](std::size_t i) { return i % 100000 < 64; };
  const bool lanes = std::all_of(repeated.begin(), repeated.end(), at_beginning);
  const unsigned bits = bits_of(u);
  expect_that(false, fmt::format("{}: {} numbers came twice", many.call(), repeated.size()),
              "none, or one", "400,000 numbers of 53 bits each are all different",
              bits < 53 ? fmt::format("these are numbers of {} bits: keep 53 of a word", bits)
              : lanes   ? "lanes begin with equal numbers: they want states that have nothing in "
                          "common, not seed, seed + 1, seed + 2"
                        : "do two calls, or two lanes, begin in the same place?");
}

CHECK_CASE("2.8 a span of any size is filled with new numbers",
           "[2.8][points:3][needs:2.1][main]") {
  Rng rng = check_rng();
  Sizes64 sizes{1000, 4096, 10007, 129, 128, 127, 65, 64, 31, 7, 3, 2, 1, 0};
  sizes.push_back(rng() % 3000);
  const std::uint64_t seed = rng();
  const Filled one(seed, sizes), again(seed, sizes), other(rng(), sizes);
  expect_that(one.numbers() == again.numbers(),
              one.call() + " gave other numbers when it was repeated", "the same numbers",
              "the generator it is given is its only source of randomness",
              "no generator of your own, no clock, nothing static");
  expect_nothing_in_common(one.call(), "numbers", one.numbers(), other.numbers());
  expect_different(rng);
}

CHECK_CASE("2.8 a call depends on its generator alone", "[2.8][points:1][edge][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t seed = rng(), another = rng(), size = 1024;
  const auto measured = MEASURE(uniforms_in_turn, {seed, another, seed}, size);
  const Values& u = measured.exactly(3 * size, unit);
  const auto alone = MEASURE(uniforms_in_turn, {another}, size);
  const auto equal = [&](std::size_t first, const Values& expected, std::size_t from) {
    return std::equal(u.begin() + static_cast<std::ptrdiff_t>(first),
                      u.begin() + static_cast<std::ptrdiff_t>(first + size),
                      expected.begin() + static_cast<std::ptrdiff_t>(from));
  };
  const std::string because = "the generator it is given is its only source of randomness";
  const std::string hint =
      "no generator of your own that stays alive between calls: nothing static";
  expect_that(equal(2 * size, u, 0),
              measured.call + ": the third generator, equal to the first, gave other numbers",
              "the same numbers", because, hint);
  expect_that(equal(size, alone.exactly(size, unit), 0),
              measured.call + ": the second generator gave other numbers than it gives alone",
              "the same numbers", because, hint);
}

CHECK_CASE("2.8 a generator of one word", "[2.8][points:1][edge][needs:2.1]") {
  for (const std::uint64_t word : {~std::uint64_t{0}, std::uint64_t{0}}) {
    const auto corner = MEASURE(uniforms_constant, word, 1024);
    corner.exactly(1024, unit);
  }
}

CHECK_CASE("2.8 the numbers are uniform in all of their bits", "[2.8][points:2][needs:2.1]") {
  Rng rng = check_rng();
  const Filled filled(rng(), {100096});
  const Values& u = filled.numbers();
  const auto n = static_cast<double>(u.size());
  expect_distribution(filled.call(), u, [](double at) { return at; },
                      {"numbers of 2.8 are uniform", alpha},
                      {{}, "each is to_unit() of 53 bits that were not used before"});
  // Bit b of floor(2^53 u) is a fair coin, and so is the XOR of two different bits.
  Values ones(53), differing(52);
  for (const double one : u) {
    const auto bits = static_cast<std::uint64_t>(one * 0x1p53);
    for (unsigned b = 0; b < 53; ++b) ones[b] += static_cast<double>(bits >> b & 1);
    for (unsigned shift = 1; shift < 53; ++shift) {
      const std::uint64_t low = (std::uint64_t{1} << (53 - shift)) - 1;
      differing[shift - 1] += std::popcount((bits ^ bits >> shift) & low);
    }
  }
  for (double& one : ones) one = (one - n / 2) / std::sqrt(n / 4);
  for (unsigned shift = 1; shift < 53; ++shift) {
    const double pairs = n * (53 - shift);
    differing[shift - 1] = (differing[shift - 1] - pairs / 2) / std::sqrt(pairs / 4);
  }
  expect_variance({filled.call() + ", z of each of 53 bits", ones, 1}, 0, 1, 3,
                  {"each bit of a number is a fair coin", alpha},
                  {{}, "53 random bits, also in the last places: which are always 0, or 1?"});
  expect_variance(
      {filled.call() + ", z of bits that differ from those 1 to 52 places on", differing, 1}, 0, 1,
      3, {"the bits of a number are independent", alpha},
      {{}, "no bit of a word is used twice in a number"});
}

CHECK_CASE("2.8 the numbers are independent", "[2.8][points:2][needs:2.1]") {
  Rng rng = check_rng();
  const std::size_t half = 50000;
  const Filled filled(rng(), {half, half});
  const Values& u = filled.numbers();
  // Three in a row: lanes that run in step are independent two by two.
  std::vector<std::uint64_t> triples(216);
  for (std::size_t i = 0; i + 2 < u.size(); i += 3) {
    const auto cell = [&](std::size_t k) { return static_cast<std::size_t>(6 * u[i + k]); };
    ++triples[36 * cell(0) + 6 * cell(1) + cell(2)];
  }
  expect_counts(filled.call() + ", three in a row, in 6 x 6 x 6 cells", triples, Values{1.0 / 216},
                {"three numbers in a row are independent", alpha},
                {{}, "do lanes run in step? Each wants a state with nothing in common"});
  // Products of centred numbers have mean 0 and variance 1/144 at every distance; also from a call
  // to the next.
  Values z;
  std::vector<std::size_t> distances(64);
  std::iota(distances.begin(), distances.end(), std::size_t{1});
  distances.push_back(half);
  for (const std::size_t distance : distances) {
    double sum = 0;
    for (std::size_t i = 0; i + distance < u.size(); ++i) {
      sum += (u[i] - 0.5) * (u[i + distance] - 0.5);
    }
    z.push_back(sum * 12 / std::sqrt(static_cast<double>(u.size() - distance)));
  }
  expect_variance(
      {filled.call() + ", z of correlations 1 to 64 places on, and from call to call", z, 1}, 0, 1,
      3, {"numbers at any distance are uncorrelated", alpha},
      {{}, "do lanes, or calls, run along the same sequence?"});
}

CHECK_CASE("2.8 the last bits do not repeat", "[2.8][points:1][needs:2.1]") {
  Rng rng = check_rng();
  const Filled filled(rng(), {150000});
  std::vector<unsigned> low;  // the eight last of 53 bits
  for (const double one : filled.numbers()) {
    low.push_back(static_cast<unsigned>(static_cast<std::uint64_t>(one * 0x1p53) & 255));
  }
  // The last bits of a linear congruential generator have a period of a few thousand: two numbers
  // a power of two apart then always agree in them.
  Values z;
  for (std::size_t distance = 1; distance <= 65536; distance *= 2) {
    Values equal(8);
    for (std::size_t i = 0; i + distance < low.size(); ++i) {
      const unsigned same = ~(low[i] ^ low[i + distance]);
      for (unsigned b = 0; b < 8; ++b) equal[b] += same >> b & 1;
    }
    const auto pairs = static_cast<double>(low.size() - distance);
    for (const double count : equal) z.push_back((count - pairs / 2) / std::sqrt(pairs / 4));
  }
  expect_variance(
      {filled.call() + ", z of equal last bits 1, 2, 4 … 65536 places on", z, 1}, 0, 1, 3,
      {"the last bits of numbers far apart are independent", alpha},
      {{},
       "the low bits of a linear congruential generator repeat soon: mix the word before it "
       "becomes a number"});
}

CHECK_CASE("2.8 the first numbers of a call are independent", "[2.8][points:1][needs:2.1]") {
  Rng rng = check_rng();
  // The first numbers of many calls against each other: lanes whose states differ by little give
  // nearly the same at first. From one generator, and from a new one for each call.
  constexpr std::size_t first = 64;
  const std::uint64_t calls = 1500, size = 160;
  const std::uint64_t seed = rng() >> 1;
  Sizes64 seeds(calls);
  std::iota(seeds.begin(), seeds.end(), seed);
  const Filled filled(rng(), Sizes64(calls, size));
  const auto in_turn = MEASURE(uniforms_in_turn, seeds, size);
  struct Calls {
    const std::string& call;
    const Values& u;
    std::string from;
  };
  for (const Calls& all :
       {Calls{filled.call(), filled.numbers(), "one generator"},
        {in_turn.call, in_turn.exactly(calls * size, unit), "neighbouring seeds"}}) {
    Values z;
    for (std::size_t i = 0; i < first; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        double sum = 0;
        for (std::size_t call = 0; call < calls; ++call) {
          sum += (all.u[call * size + i] - 0.5) * (all.u[call * size + j] - 0.5);
        }
        z.push_back(sum * 12 / std::sqrt(static_cast<double>(calls)));
      }
    }
    // Two z that share a number have squares with the covariance (1.8 - 1) / calls, and each shares
    // one with 2 (first - 2) others: that much wider is the sum of their squares.
    const double shared = 0.8 * 2 * (first - 2) / static_cast<double>(calls);
    expect_variance(
        {all.call + ", z of correlations between the first 64 numbers of a call", z, 1}, 0, 1,
        3 + shared, {"the first numbers of calls from " + all.from + " are independent", alpha},
        {{},
         "each call begins with numbers that resemble each other: lanes want states that have "
         "nothing in common, not seed, seed + 1, seed + 2"});
    // The first number of a call against that of the next.
    double sum = 0;
    for (std::size_t call = 0; call + 1 < calls; ++call) {
      sum += (all.u[call * size] - 0.5) * (all.u[(call + 1) * size] - 0.5);
    }
    const Values one{12 * sum / std::sqrt(static_cast<double>(calls - 1))};
    expect_mean({all.call + ", z of the first numbers of a call and of the next", one, 1}, 0, 1,
                {"calls from " + all.from + " begin independently", alpha},
                {{}, "what does a call leave in the generator for the next?"});
  }
}

}  // namespace
}  // namespace mc::checks
