// 1.4: Welford's update.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "exact_merge.hpp"
#include "expect_variance.hpp"

namespace mc::checks {
namespace {

const std::string no_squares =
    "keep the mean and the squared deviations from it, not the sum of x^2; is anything a float?";

CHECK_CASE("1.4 add keeps count and mean and m2", "[1.4][main][points:5]") {
  Rng rng = check_rng();
  for (const std::size_t n : {10u, 1000u, 3u, 2u, 1u}) {
    const auto x = tame_values(rng, n, 1, 2);
    const auto exact = exact_moments(x);
    const auto mean = static_cast<double>(exact.mean), m2 = static_cast<double>(exact.m2);
    const auto got = MEASURE(welford, x);
    expect_moments(
        got.call, got.value, exact, two_pass_floor(n), n > 1 ? one_pass_floor(exact) : 0,
        because_one_pass,
        {nearest(
             got.value.mean, mean,
             {{x[0],
               "the mean stays at the first value: is 1 / count an integer division, which is 0?"},
              {mean * exact.count, "this is the sum: the mean moves by (x - mean) / count"}}),
         or_float(got.value.mean, mean,
                  "the mean moves by (x - mean)/count, with the count that includes x; is anything "
                  "here a float?")},
        welford_hints(got.value.m2, x, exact, 1,
                      or_float(got.value.m2, m2,
                               "m2 grows by (x - old mean)(x - new mean), and keeps no sum of "
                               "x^2")));
  }
  const auto none = MEASURE(welford, {});
  expect_nothing(none.call, none.value, "nothing was added",
                 "leave the members' initial values as they are");
}

CHECK_CASE("1.4 the variance of moments", "[1.4][points:2]") {
  Rng rng = check_rng();
  const std::uint64_t counts[] = {3 + rng() % 1000, 5 + (rng() >> 16), 2};
  for (const std::uint64_t count : counts) {
    const double m2 = uniform(rng, 1, 9);
    const auto got = MEASURE(variance_of, {count, uniform(rng, -9, 9), m2});
    const auto n = static_cast<double>(count);
    const double exact = m2 / (n - 1);
    expect_digits(got.call, got.value, exact, 14.5, "one division, rounded once or twice",
                  {nearest(got.value, exact,
                           {{m2 / n, "this divides by n; a sample variance divides by n - 1"},
                            {m2, "this is m2: divide it by count - 1"},
                            {std::sqrt(exact),
                             "this is the standard deviation: the variance is its square"}}),
                   "m2 / (count - 1); is the count a whole number of 64 bits all the way?"});
  }
}

CHECK_CASE("1.4 the variance of fewer than two values is NaN", "[1.4][edge][points:1]") {
  for (const std::uint64_t count : {1u, 0u}) {
    const auto got = MEASURE(variance_of, {count, count == 0 ? 0 : 2.5, 0});
    expect_nan(got.call, got.value, "a sample variance needs two values; " + because_undefined);
  }
}

CHECK_CASE("1.4 Welford keeps his digits under a large mean", "[1.4][points:3]") {
  Rng rng = check_rng();
  const auto judge = [](const std::string& name, const Values& x) {
    const auto exact = exact_moments(x);
    const auto got = MEASURE(welford, x);
    expect_digits(fmt::format("{}.m2{}", got.call, name), got.value.m2,
                  static_cast<double>(exact.m2), one_pass_floor(exact), because_one_pass,
                  welford_hints(got.value.m2, x, exact, 1, no_squares));
  };
  for (const double offset : {1e6, 1e9, 1e12, 1e13, 1e14, 1e15}) {
    for (const std::size_t n : {1000u, 4u}) judge("", shifted_pattern(rng, offset, n));
  }
  for (const int number : {1, 2, 3, 4}) {
    judge(fmt::format(", NIST's NumAcc{}", number), numacc(number, rng));
  }
}

Variance by_welford(const Values& x) {
  const auto got = MEASURE(welford, x);
  return {got.value.m2 / static_cast<double>(x.size() - 1), "m2 / (n - 1) of " + got.call};
}

CHECK_CASE("1.4 Welford on constant data and hard cases", "[1.4][points:3]") {
  Rng rng = check_rng();
  const auto hints = [](double got, const Values& x, const ExactMoments& exact,
                        const std::string& otherwise) {
    return welford_hints(got, x, exact, exact.count - 1, otherwise);
  };
  for (const double c : {0.1, 1e8 / 3, uniform(rng, 1, 2)}) {
    const Values x(1000, c);
    const double bound = 1000 * eps * c;
    const auto got = by_welford(x);
    const std::string because =
        "n roundings of the mean lose at most n eps |c|, and m2 is a sum of squares of that";
    expect_within(got.call, got.value, 0, bound * bound, because,
                  hints(got.value, x, exact_moments(x), no_squares));
    expect_that(got.value >= 0, fmt::format("{} = {}", got.call, got.value), "0, never less",
                because,
                "x lies on the same side of the old mean and of the new one: no product of the two "
                "deviations is negative");
  }
  expect_hard_variance(rng, {by_welford, one_pass_floor, because_one_pass, hints});
}

CHECK_CASE("1.4 one more value after very many", "[1.4][edge][points:2]") {
  Rng rng = check_rng();
  struct End {
    int bits;
    const char* hint;
  };
  // Just before the end of what a type counts exactly, and behind it, where every second count is
  // none of its numbers.
  for (const End& end :
       {End{24, "a float counts to 2^24 only"}, End{31, "an int counts to 2^31 only"},
        End{32, "32 bits count to 2^32 only"},
        End{53, "a double counts to 2^53 only: ++ a whole number of 64 bits"},
        End{62, "count is a whole number of 64 bits: keep it one"}}) {
    for (const bool behind : {false, true}) {
      const std::uint64_t step = 2 * (1 + rng() % 50);
      const std::uint64_t power = std::uint64_t{1} << end.bits;
      const Moments many{behind ? power + step : power - 1, uniform(rng, 1, 2), uniform(rng, 1, 2)};
      // So far away that one value moves the mean by 1 or more, and m2 is that distance squared.
      const double x = static_cast<double>(many.count) * uniform(rng, 1, 2);
      const ExactMoments exact = exact_merge(many, {1, x, 0});
      const auto got = MEASURE(stream, many, {x}, 1);
      expect_that(got.value.count == many.count + 1,
                  fmt::format("{}.count = {}", got.call, got.value.count),
                  fmt::format("{}", many.count + 1), "one value more was added", end.hint);
      // Six digits: a count that is one off changes the eighth, one that wrapped round all of them.
      const std::string because = "a right count keeps all digits; six are asked for here";
      expect_digits(got.call + ".mean", got.value.mean, static_cast<double>(exact.mean), 6, because,
                    {{}, end.hint});
      expect_digits(got.call + ".m2", got.value.m2, static_cast<double>(exact.m2), 6, because,
                    {{}, end.hint});
      const auto variance = MEASURE(variance_of, many);
      expect_digits(variance.call, variance.value, many.m2 / static_cast<double>(many.count - 1), 6,
                    because, {{}, end.hint});
    }
  }
}

CHECK_CASE("1.4 Welford survives a stream of 1e8 values", "[1.4][edge][points:2][slow]") {
  Rng rng = check_rng();
  // The same few values over and over: their mean, and their m2 as often as they come.
  const Values x = tame_values(rng, 4 + 2 * (rng() % 3), 4, 16);
  const auto of_x = exact_moments(x);
  constexpr int pieces = 20;  // no measurement takes long: one goes on where the last one ended
  const std::uint64_t times = 5'000'000 / x.size();
  const std::uint64_t count = times * x.size();
  Moments all;
  std::string call;
  for (int piece = 1; piece <= pieces; ++piece) {
    const auto got = MEASURE(stream, all, x, count);
    const std::uint64_t due = count * static_cast<std::uint64_t>(piece);
    all = got.value;
    call = got.call;
    expect_that(all.count == due, fmt::format("{}.count = {}", call, all.count),
                fmt::format("{}", due), "", "a float counts to 2^24 only, an int to 2^31");
  }
  // The same values over and over are rounded in the same way over and over: n/4 eps at most, 8.3
  // digits. 9.0 and more were measured, of the mean and of m2.
  const Hints hints{{},
                    "if short lists are right: is anything a float? Does anything grow with the "
                    "count that need not?",
                    late_count};
  const auto repeats = static_cast<double>(times) * pieces;
  const double floor = repeating_floor(all.count);
  expect_digits(call + ".mean", all.mean, static_cast<double>(of_x.mean), floor, because_repeating,
                hints);
  expect_digits(call + ".m2", all.m2, static_cast<double>(of_x.m2) * repeats, floor,
                because_repeating, hints);
}

}  // namespace
}  // namespace mc::checks
