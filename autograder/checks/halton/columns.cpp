// 5.2: radical inverses of consecutive indices.

#include "5-halton/experiments.hpp"
#include "checks/halton/expect_inverse.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("5.2 a column has the radical inverses of 0 1 2 and so on",
           "[5.2][points:5][needs:5.1][main]") {
  Rng rng = check_rng();
  for (const unsigned base : {3u, 2u, 5u, 29u, 31u, 131u, 7919u, 4294967295u}) {
    for (const std::uint64_t count : {std::uint64_t{4096}, 1 + rng() % 300, std::uint64_t{7},
                                      std::uint64_t{1}, std::uint64_t{0}}) {
      const auto measured = MEASURE(radical_inverses, base, 0, count);
      expect_column(measured.call, measured.exactly(count, any_number), base, 0,
                    "5.1 says what every value must be");
    }
  }
}

CHECK_CASE("5.2 a column may begin anywhere", "[5.2][points:4][needs:5.1]") {
  Rng rng = check_rng();
  const std::string otherwise =
      "right from 0 on, and not from here? Look at the first and the last few values of the column";
  for (const unsigned base : {3u, 2u, 7u, 31u, 7919u}) {
    std::vector<std::uint64_t> firsts{1 + rng() % 5000, (std::uint64_t{1} << 32) - 1 - rng() % 100,
                                      (std::uint64_t{1} << 63) - 1 - rng() % 100, rng() >> 1,
                                      last_index - 599};  // the last index of all is the last value
    std::uint64_t power = base;
    while (power < 1000000000) power *= base;
    // The first failure is what is explained: at the last index of a block, where the block's
    // beginning, the index before and 0 are three different things.
    const std::uint64_t block = base < 100 ? base * base : base;
    firsts[0] += block - 1 - firsts[0] % block;
    firsts.push_back(power - 1 - rng() % 300);  // nine digits or more change at once
    for (const std::uint64_t first : firsts) {
      const std::uint64_t count = first == last_index - 599 ? 600 : 300 + rng() % 1500;
      const auto measured = MEASURE(radical_inverses, base, first, count);
      expect_column(measured.call, measured.exactly(count, any_number), base, first, otherwise);
    }
  }
}

CHECK_CASE("5.2 every value of a column is below 1", "[5.2][points:2][needs:5.1][edge]") {
  const auto expect_below_1 = [](unsigned base, std::uint64_t first, std::uint64_t count) {
    MEASURE(radical_inverses, base, first, count).exactly(count, unit);
  };
  for (const unsigned base : {2u, 5u, 11u, 29u, 31u}) {
    for (std::uint64_t power = 1; power <= last_index / base;) {
      power *= base;
      if (power >> 50 != 0) expect_below_1(base, power - 1050, 1050);
    }
  }
  expect_below_1(2, last_index - 2047, 2048);
}

CHECK_CASE("5.2 a column past the last index is refused", "[5.2][points:1][edge]") {
  for (const unsigned base : {0u, 1u}) {
    expect_refused(MEASURE_OUTCOME(radical_inverses, base, 0, 10),
                   "there are no digits below base 2");
  }
  expect_refused(MEASURE_OUTCOME(radical_inverses, 3, last_index - 1, 3),
                 "the last index is 2^64 - 1, and the third one would be 2^64");
}

}  // namespace
}  // namespace mc::checks
