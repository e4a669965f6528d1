// What lab 1 checks. Every exact value is computed here, in 106 bits, from the very doubles that
// were sent; every data set is fresh in each run. Floors come from two bounds (Chan, Golub, LeVeque
// 1983, table 2), with a digit of room for their constants:
//
//   n eps          what n additions may lose in any order       two passes, shifted, in blocks
//   n kappa eps    what a mean rounded n times may lose,        one pass (Welford, merging)
//                  kappa = sqrt(1 + mean^2 / variance)
//
// Roundings that scatter lose sqrt(n) where these bounds say n: the algorithms themselves are
// measured one to three digits above their floors.

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

#include <fmt/format.h>

#include "1-variance/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double room = 1;  // digits

double floor_of(double lost) {
  return std::min(16.0, -std::log10(lost)) - room;
}
double two_pass_floor(std::size_t n) {
  return floor_of(static_cast<double>(n) * eps);
}

double condition(const ExactMoments& exact) {
  const double mean = static_cast<double>(exact.mean);
  return std::sqrt(1 + mean * mean / exact.variance);
}
double one_pass_floor(const ExactMoments& exact) {
  return floor_of(exact.count * condition(exact) * eps);
}

const std::string because_two_pass =
    "n additions lose at most n eps of the sum, whatever their order; a digit is left beyond that";
const std::string because_one_pass =
    "a running mean is rounded n times to eps |mean|, each of which costs the variance a part "
    "eps |mean| / sigma; a digit is left beyond that";
const std::string because_undefined = "what is undefined is NaN, as in numpy and R";

// Data --------------------------------------------------------------------------------------------

/// Uniform values of which the first two lie in the first and in the last quarter, so that the
/// variance of two or three is never small beside their mean by chance: kappa is below 2 for those
/// in [-1, 1), below 7 in [1, 2).
Values tame_values(Rng& rng, std::size_t n, double low, double high) {
  Values x = uniform_values(rng, n, low, high);
  const double quarter = (high - low) / 4;
  if (n > 1) x[0] = uniform(rng, low, low + quarter), x[1] = uniform(rng, high - quarter, high);
  return x;
}

/// offset + r + {4, 7, 13, 16} over and over in random order, r a whole number below 1000. Exact in
/// double up to offsets of 1e15; mean offset + r + 10, and 22.5 n/(n-1) for the variance.
Values shifted_pattern(Rng& rng, double offset, std::size_t n) {
  const double base = offset + static_cast<double>(rng() % 1000);
  const double pattern[] = {4, 7, 13, 16};
  Values x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = base + pattern[i % 4];
  std::shuffle(x.begin(), x.end(), rng);
  return x;
}

/// The data sets of NIST's Statistical Reference Datasets, "univariate summary statistics", NumAcc1
/// to NumAcc4, times a power of two, which changes no digit of anything.
Values numacc(int number, Rng& rng) {
  const double scale = std::ldexp(1.0, static_cast<int>(rng() % 17) - 8);
  if (number == 1) return {10000001 * scale, 10000003 * scale, 10000002 * scale};
  const double first[] = {1.2, 1000000.2, 10000000.2};
  const double low[] = {1.1, 1000000.1, 10000000.1};
  const double high[] = {1.3, 1000000.3, 10000000.3};
  Values x{first[number - 2] * scale};
  for (int i = 0; i < 500; ++i) {
    x.push_back(low[number - 2] * scale);
    x.push_back(high[number - 2] * scale);
  }
  return x;
}

double textbook_from_means(const Values& x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (const double value : x) sum += value, squares += value * value;
  return (squares / n - sum / n * (sum / n)) * n / (n - 1);
}

double textbook_from_sums(const Values& x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0;
  for (const double value : x) sum += value, squares += value * value;
  return (squares - sum * sum / n) / (n - 1);
}

double two_pass_here(const Values& x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0, squares = 0, rest = 0;
  for (const double value : x) sum += value;
  for (const double value : x)
    squares += (value - sum / n) * (value - sum / n), rest += value - sum / n;
  return (squares - rest * rest / n) / (n - 1);
}

/// What Welford's update makes of x, and what each of its two well-known misreadings does.
struct Welford {
  double m2 = 0;
  double from_old_means = 0;  ///< (x - old mean)^2 in place of (x - old mean)(x - new mean)
  double from_new_means = 0;  ///< (x - new mean)^2
};
Welford welford_here(const Values& x) {
  Welford sums;
  double mean = 0, count = 0;
  for (const double value : x) {
    const double before = value - mean;
    mean += before / ++count;
    const double after = value - mean;
    sums.m2 += before * after;
    sums.from_old_means += before * before;
    sums.from_new_means += after * after;
  }
  return sums;
}

// Hints -------------------------------------------------------------------------------------------

const std::string late_count = "the first value was divided by a count of 0: count it before";
const std::string empty_part = "0/0 is NaN: look for an empty part first";

/// Where no suspect fits, some digits are a sign of their own: data that cost a double three digits
/// at most, and seven are left.
std::string or_float(double got, double exact, const std::string& otherwise) {
  const double kept = digits(got, exact);
  return kept > 4.5 && kept < 10 ? "these are the digits of a float: make it a double" : otherwise;
}

/// The ways to get the scale of a variance wrong.
std::vector<Suspect> scale_suspects(const ExactMoments& exact) {
  const double n = exact.count;
  return {{exact.variance * (n - 1) / n, "this divides by n; a sample variance divides by n - 1"},
          {exact.variance * n / (n - 1), "n/(n-1) is in here twice: once is enough"},
          {exact.variance * (n - 1), "this is the sum of squared deviations, not divided yet"},
          {std::sqrt(exact.variance), "this is the standard deviation: the variance is its square"},
          {-exact.variance, "the sign is wrong: E{X^2} is the larger one"},
          {static_cast<double>(exact.m2 / exact.count + exact.mean * exact.mean),
           "this is E{X^2}: take E{X}^2 off"}};
}

/// For a variance of tame data.
Hints variance_hints(double got, const ExactMoments& exact, const std::string& otherwise) {
  return {scale_suspects(exact), or_float(got, exact.variance, otherwise)};
}

const std::string large_numbers =
    "these are the digits that E{X^2} - E{X}^2 gives: two large numbers, nearly equal";

/// For a variance of hard data: also other algorithms under this one's name.
Hints hard_variance_hints(const Values& x, const ExactMoments& exact,
                          const std::string& otherwise) {
  auto suspects = scale_suspects(exact);
  suspects.push_back({textbook_from_means(x), large_numbers});
  suspects.push_back({textbook_from_sums(x), large_numbers});
  suspects.push_back({welford_here(x).m2 / (exact.count - 1),
                      "these are the digits of a running mean, rounded at every step: 1.4's"});
  return {suspects, otherwise};
}

/// For m2 by Welford's update, `divided` by something or by nothing.
Hints welford_hints(const Values& x, double divided, const std::string& otherwise) {
  const Welford sums = welford_here(x);
  return {{{sums.from_old_means / divided,
            "m2 grows by (x - old mean)(x - new mean); this is the old one, twice"},
           {sums.from_new_means / divided,
            "m2 grows by (x - old mean)(x - new mean); this is the new one, twice"}},
          otherwise,
          late_count};
}

void expect_moments(const std::string& call, const Moments& got, const ExactMoments& exact,
                    double mean_floor, double m2_floor, const std::string& because,
                    const Hints& mean_hints, const Hints& m2_hints) {
  expect_that(static_cast<double>(got.count) == exact.count,
              fmt::format("{}.count = {}", call, got.count), fmt::format("{}", exact.count), "",
              "every value counts once, also those in a last, shorter block");
  expect_digits(call + ".mean", got.mean, static_cast<double>(exact.mean), mean_floor, because,
                mean_hints);
  if (exact.m2.high == 0) {
    expect_within(call + ".m2", got.m2, 0, 0, "one value does not deviate from itself", m2_hints);
  } else {
    expect_digits(call + ".m2", got.m2, static_cast<double>(exact.m2), m2_floor, because, m2_hints);
  }
}

// 1.1 ---------------------------------------------------------------------------------------------

TEST_CASE("1.1 the mean of a list of values", "[1.1][points:6]") {
  Rng rng = check_rng();
  for (const std::size_t n : {1u, 2u, 3u, 10u, 1000u}) {
    const auto x = uniform_values(rng, n, 1, 2);
    const auto got = MEASURE(mean, x);
    const double exact = static_cast<double>(exact_mean(x));
    const auto size = static_cast<double>(n);
    expect_digits(
        got.call, got.value, exact, two_pass_floor(n), because_two_pass,
        {{{exact * size / (size - 1), "this divides by n - 1; only the variance does"},
          {exact * size, "this is the sum: divide it by n"}},
         or_float(got.value, exact, "add the values up and divide by how many there are")});
  }
  for (const int number : {1, 2, 3, 4}) {
    const auto x = numacc(number, rng);
    const auto got = MEASURE(mean, x);
    expect_digits(fmt::format("{}, NIST's NumAcc{}", got.call, number), got.value,
                  static_cast<double>(exact_mean(x)), two_pass_floor(x.size()), because_two_pass,
                  {{}, "is every sum a double? A float keeps seven digits"});
  }
  const auto nothing = MEASURE(mean, {});
  expect_nan(nothing.call, nothing.value, "the mean of nothing is 0/0; " + because_undefined);
}

TEST_CASE("1.1 the mean is finite wherever it is a double", "[1.1][points:4]") {
  Rng rng = check_rng();
  const double huge = uniform(rng, 1.6e308, 1.79e308);
  const std::string because =
      "a mean lies between the smallest and the largest value, so it is finite";
  const Hints hints{{{huge * 0.4, "this divides by n - 1; only the variance does"}},
                    "the sum overflows where the mean does not: notice it, and sum x/n instead; a "
                    "float ends at 3.4e38 already"};
  Values many(1000);
  for (double& value : many) value = uniform(rng, 1e308, 1.79e308);
  Values opposite;
  for (int i = 0; i < 6; ++i) opposite.push_back(i < 4 ? huge : -huge);

  const auto cancelling = MEASURE(mean, opposite);
  expect_digits(cancelling.call, cancelling.value, huge / 3, two_pass_floor(20), because, hints);
  const auto two = MEASURE(mean, {1e308, 1e308});
  expect_digits(two.call, two.value, 1e308, two_pass_floor(2), because, hints);
  const auto both = MEASURE(mean, {huge, -huge, huge, -huge});
  expect_within(both.call, both.value, 0, huge * 8 * eps, because, hints);
  const auto most = MEASURE(mean, many);
  Values smaller = many;  // 2^-20 times the data, exactly: sums that fit
  for (double& value : smaller) value *= 0x1p-20;
  expect_digits(most.call, most.value, static_cast<double>(exact_mean(smaller)) * 0x1p20,
                two_pass_floor(1000), because, hints);
}

// 1.2 ---------------------------------------------------------------------------------------------

TEST_CASE("1.2 the textbook formula gives the variance of tame data", "[1.2][points:6]") {
  Rng rng = check_rng();
  for (const std::size_t n : {2u, 3u, 10u, 1000u}) {
    const auto x = tame_values(rng, n, -1, 1);
    const auto exact = exact_moments(x);
    const auto got = MEASURE(variance_textbook, x);
    const double kappa = condition(exact);
    expect_digits(got.call, got.value, exact.variance,
                  floor_of(static_cast<double>(n) * eps * kappa * kappa),
                  "n additions lose n eps, and the difference magnifies it by E{X^2} / Var{X}",
                  variance_hints(got.value, exact, "E{X^2} - E{X}^2, times n/(n-1)"));
  }
  for (const Values& x : {Values{}, Values{uniform(rng, -1, 1)}}) {
    const auto got = MEASURE(variance_textbook, x);
    expect_nan(got.call, got.value,
               "there is no sample variance of fewer than two values; " + because_undefined);
  }
}

TEST_CASE("1.2 the textbook formula loses everything under a large mean", "[1.2][points:4]") {
  Rng rng = check_rng();
  const auto tame = shifted_pattern(rng, 0, 1000);  // beside it, so that a constant is no answer
  const auto near_zero = MEASURE(variance_textbook, tame);
  expect_digits(near_zero.call, near_zero.value, exact_moments(tame).variance, 2,
                "the mean is below 1010 here, and costs six digits of sixteen at most",
                {{}, "E{X^2} - E{X}^2, times n/(n-1); see the check before this one"});
  for (const std::size_t n : {4u, 1000u}) {
    const auto x = shifted_pattern(rng, 1e9, n);
    const auto exact = exact_moments(x);
    const auto got = MEASURE(variance_textbook, x);
    // 1e18 has an ulp of 128: either form of the formula can only give a multiple of some
    // power of two that is far from 22.5 n/(n-1). Two digits would take an ulp below 0.4.
    expect_that(
        !(digits(got.value, exact.variance) >= 2),
        fmt::format("{} = {}, which is right to {:.1f} digits", got.call, got.value,
                    digits(got.value, exact.variance)),
        "a number with no right digit, as E{X^2} - E{X}^2 gives here in double",
        "this task is here to be seen failing: both terms are 1e18, known to the nearest 128",
        "this is a better algorithm under the textbook's name, or a wider type; keep it for 1.3");
  }
}

// 1.3 ---------------------------------------------------------------------------------------------

TEST_CASE("1.3 the two-pass variance of tame data", "[1.3][points:5][needs:1.1]") {
  Rng rng = check_rng();
  for (const std::size_t n : {2u, 3u, 10u, 1000u}) {
    const auto x = tame_values(rng, n, -1, 1);
    const auto exact = exact_moments(x);
    const auto got = MEASURE(variance_two_pass, x);
    expect_digits(got.call, got.value, exact.variance, two_pass_floor(n), because_two_pass,
                  variance_hints(got.value, exact, "sum (x - mean)^2 and divide by n - 1"));
  }
  for (const Values& x : {Values{}, Values{uniform(rng, -1, 1)}}) {
    const auto got = MEASURE(variance_two_pass, x);
    expect_nan(got.call, got.value,
               "there is no sample variance of fewer than two values; " + because_undefined);
  }
}

/// Two passes without the correction lose what the rounding of the mean costs: (n eps kappa)^2 of
/// the variance at most. Who loses more went another way.
Hints two_pass_hints(double got, const Values& x, const ExactMoments& exact) {
  const double rounded_mean = exact.count * eps * condition(exact);
  return hard_variance_hints(
      x, exact,
      digits(got, exact.variance) > floor_of(rounded_mean * rounded_mean)
          ? "the mean was rounded: take (sum of deviations)^2 / n off the sum of squares"
          : "more is lost than a rounded mean can cost: is this E{X^2} - E{X}^2, or a float?");
}

TEST_CASE("1.3 two passes keep their digits under a large mean", "[1.3][points:6][needs:1.1]") {
  Rng rng = check_rng();
  const auto judge = [](const Values& x, const std::string& name) {
    const auto exact = exact_moments(x);
    const auto got = MEASURE(variance_two_pass, x);
    expect_digits(got.call + name, got.value, exact.variance, two_pass_floor(x.size()),
                  because_two_pass, two_pass_hints(got.value, x, exact));
  };
  for (const int number : {1, 2, 3, 4}) {
    judge(numacc(number, rng), fmt::format(", NIST's NumAcc{}", number));
  }
  for (const double offset : {1e6, 1e9, 1e12, 1e13, 1e14, 1e15}) {
    for (const std::size_t n : {4u, 1000u}) judge(shifted_pattern(rng, offset, n), "");
  }
}

TEST_CASE("1.3 the variance of constant data is zero", "[1.3][points:4][needs:1.1]") {
  Rng rng = check_rng();
  const auto expect_not_negative = [](const Measured<double>& got) {
    expect_that(got.value >= 0, fmt::format("{} = {}", got.call, got.value), "0, never less",
                "a variance is a mean of squares",
                "what the correction takes away can be rounded up: stop at 0");
  };
  const auto pattern = shifted_pattern(rng, 0, 1000);  // beside it, so that 0 is no answer
  const auto varying = MEASURE(variance_two_pass, pattern);
  expect_digits(varying.call, varying.value, exact_moments(pattern).variance, 2,
                "these values are not constant", {{}, "see the first check of this task"});
  // A sum of n equal values is off by n^2/4 eps |c| at most, the mean by d = n/4 eps |c|; every
  // deviation is d, and what the correction leaves of n d^2 is again a rounding error, 3/4 n eps of
  // it. That is 3/64 n^3 eps (eps c)^2 in all: 1 % of (eps c)^2 for n = 1e5 (a tenth, if the sums
  // are taken in an unlucky order), and nothing where the mean is corrected first.
  for (const double c : {0.1, 1e8 / 3, uniform(rng, 1, 2), -uniform(rng, 1e5, 1e6)}) {
    for (const std::size_t n : {2u, 1000u, 100000u}) {
      const Values x(n, c);
      const auto got = MEASURE(variance_two_pass, x);
      const double rounded_mean = static_cast<double>(n) * eps * c;
      const bool is_textbook = std::abs(got.value) > rounded_mean * rounded_mean;
      expect_within(
          got.call, got.value, 0, eps * eps * c * c,
          "a rounded mean may be wrong by n eps |c|, but the correction leaves less than "
          "one rounding of c, squared",
          {{},
           is_textbook ? large_numbers
                       : "the rounded mean is not c: take (sum of deviations)^2 / n off"});
      expect_not_negative(got);
    }
  }
  // Up to n = 3e5 or so the two parts of eq. 1.7 are whole multiples of ulp(c)^2, exact in double,
  // and differ by 0. Beyond, every fourth constant takes their difference below.
  Values x;
  do {
    x.assign(std::size_t{1} << 20, uniform(rng, 1, 2));
  } while (two_pass_here(x) >= 0);
  expect_not_negative(MEASURE(variance_two_pass, x));
}

/// Finite values whose variance, 1e600 and more, is none.
const Values beyond_double[] = {{1e300, 2e300, 3e300}, {1.7e308, -1.7e308, 1.7e308, -1.7e308}};

void expect_overflow(const std::string& call, double got) {
  expect_that(!std::isfinite(got), fmt::format("{} = {}", call, got), "inf or NaN",
              "the variance is 1e600 or more, which no double holds",
              "a finite number here is made up; is it std::max(0.0, NaN), which is 0?");
}

/// The hard cases that any sample variance of a list must get through, by whatever way.
struct Algorithm {
  std::function<Measured<double>(const Values&)> variance;
  std::function<double(const ExactMoments&)> floor;
  std::function<Hints(const Values&, const ExactMoments&, const std::string& otherwise)> hints;
  std::string because;  ///< where the floor comes from
};
void expect_hard_variance(Rng& rng, const Algorithm& by) {
  const double large = uniform(rng, 1, 9) * 1e150;
  const double tiny = uniform(rng, 1, 9) * 1e-160;
  const double outlier = uniform(rng, 1e9, 1e10);

  // 1.3 and Welford alike: the scale of the numbers is no matter.
  const Values large_values{large, 2 * large, 3 * large};
  const auto big = by.variance(large_values);
  expect_digits(big.call, big.value, large * large, two_pass_floor(3),
                "the variance of {c, 2c, 3c} is c^2, a double here",
                by.hints(large_values, exact_moments(large_values),
                         "does anything overflow that need not: a product, a float?"));
  for (const Values& x : beyond_double) {
    const auto overflow = by.variance(x);
    expect_overflow(overflow.call, overflow.value);
  }
  const Values tiny_values{tiny, 2 * tiny, 3 * tiny};
  const auto small = by.variance(tiny_values);
  expect_within(small.call, small.value, tiny * tiny, 4 * std::numeric_limits<double>::denorm_min(),
                "the variance is about 1e-320, a denormal with a few bits left",
                by.hints(tiny_values, exact_moments(tiny_values),
                         "small is not zero: no threshold belongs in here"));

  Values one_outlier(1000, 1.0);
  one_outlier[rng() % 1000] = outlier;
  Values sorted = uniform_values(rng, 1000, 0, 1);
  std::sort(sorted.begin(), sorted.end());
  Values trend(1000);
  std::iota(trend.begin(), trend.end(), uniform(rng, 1e5, 1e6));
  Values alternating{1.0};
  for (int i = 0; i < 500; ++i) alternating.insert(alternating.end(), {1e8, -1e8});
  const std::pair<const char*, const Values*> cases[] = {{"one outlier", &one_outlier},
                                                         {"sorted", &sorted},
                                                         {"a trend", &trend},
                                                         {"alternating", &alternating}};
  for (const auto& [name, x] : cases) {
    const auto exact = exact_moments(*x);
    const auto got = by.variance(*x);
    expect_digits(fmt::format("{}, {}", got.call, name), got.value, exact.variance, by.floor(exact),
                  by.because, by.hints(*x, exact, "a sum that starts far from the mean?"));
  }
}

TEST_CASE("1.3 two passes on hard cases", "[1.3][points:3][needs:1.1]") {
  Rng rng = check_rng();
  expect_hard_variance(rng, {[](const Values& x) { return MEASURE(variance_two_pass, x); },
                             [](const ExactMoments& exact) {
                               return two_pass_floor(static_cast<std::size_t>(exact.count));
                             },
                             hard_variance_hints, because_two_pass});
}

// 1.4 ---------------------------------------------------------------------------------------------

TEST_CASE("1.4 add keeps count and mean and m2", "[1.4][points:5]") {
  Rng rng = check_rng();
  const auto none = MEASURE(welford, {});
  expect_that(none.value.count == 0 && none.value.mean == 0 && none.value.m2 == 0,
              none.call + " = " + shown(none.value), "count, mean and m2 all 0",
              "nothing was added", "leave the members' initial values as they are");
  for (const std::size_t n : {1u, 2u, 3u, 10u, 1000u}) {
    const auto x = tame_values(rng, n, 1, 2);
    const auto exact = exact_moments(x);
    const auto got = MEASURE(welford, x);
    Hints m2_hints = welford_hints(
        x, 1,
        or_float(got.value.m2, static_cast<double>(exact.m2),
                 "m2 grows by (x - old mean)(x - new mean), and keeps no sum of x^2"));
    m2_hints.suspects.push_back({exact.variance, "m2 is a sum: variance() divides it, once"});
    expect_moments(got.call, got.value, exact, two_pass_floor(n), n > 1 ? one_pass_floor(exact) : 0,
                   because_one_pass,
                   {{},
                    or_float(got.value.mean, static_cast<double>(exact.mean),
                             "the mean moves by (x - mean)/count, with the count that includes x")},
                   m2_hints);
  }
}

TEST_CASE("1.4 the variance of moments", "[1.4][points:3]") {
  Rng rng = check_rng();
  for (const std::uint64_t count : {std::uint64_t{2}, 3 + rng() % 1000, 5 + (rng() >> 16)}) {
    const double m2 = uniform(rng, 1, 9);
    const auto got = MEASURE(variance_of, {count, uniform(rng, -9, 9), m2});
    const auto n = static_cast<double>(count);
    expect_digits(
        got.call, got.value, m2 / (n - 1), 14.5, "one division, rounded once or twice",
        {{{m2 / n, "this divides by n; a sample variance divides by n - 1"},
          {m2, "this is m2: divide it by count - 1"},
          {std::sqrt(m2 / (n - 1)), "this is the standard deviation: the variance is its square"}},
         "m2 / (count - 1); is the count a whole number of 64 bits all the way?"});
  }
  for (const std::uint64_t count : {0u, 1u}) {
    const auto got = MEASURE(variance_of, {count, count * 2.5, 0});
    expect_nan(got.call, got.value,
               "there is no sample variance of fewer than two values; " + because_undefined);
  }
}

TEST_CASE("1.4 Welford keeps his digits under a large mean", "[1.4][points:4]") {
  Rng rng = check_rng();
  const auto judge = [](const std::string& name, const Values& x) {
    const auto exact = exact_moments(x);
    const auto got = MEASURE(welford, x);
    expect_digits(
        fmt::format("{}.m2{}", got.call, name), got.value.m2, static_cast<double>(exact.m2),
        one_pass_floor(exact), because_one_pass,
        welford_hints(x, 1,
                      "keep the mean and the squared deviations from it, not the sum of x^2; is "
                      "anything a float?"));
  };
  for (const int number : {1, 2, 3, 4}) {
    judge(fmt::format(", NIST's NumAcc{}", number), numacc(number, rng));
  }
  for (const double offset : {1e6, 1e9, 1e12, 1e13, 1e14, 1e15}) {
    for (const std::size_t n : {4u, 1000u}) judge("", shifted_pattern(rng, offset, n));
  }
}

TEST_CASE("1.4 Welford on constant data and hard cases", "[1.4][points:3]") {
  Rng rng = check_rng();
  const auto variance_by_welford = [](const Values& x) {
    const auto got = MEASURE(welford, x);
    return Measured<double>{got.value.m2 / static_cast<double>(got.value.count - 1),
                            "variance of " + got.call};
  };
  const auto hints = [](const Values& x, const ExactMoments& exact, const std::string& otherwise) {
    return welford_hints(x, exact.count - 1, otherwise);
  };
  for (const double c : {0.1, 1e8 / 3, uniform(rng, 1, 2)}) {
    const Values x(1000, c);
    const double bound = 1000 * eps * c;
    const auto got = variance_by_welford(x);
    const std::string because =
        "n roundings of the mean lose at most n eps |c|, and m2 is a sum of squares of that";
    expect_within(got.call, got.value, 0, bound * bound, because,
                  hints(x, exact_moments(x),
                        "keep the mean and the squared deviations from it, not the sum of x^2; is "
                        "anything a float?"));
    expect_that(got.value >= 0, fmt::format("{} = {}", got.call, got.value), "0, never less",
                because,
                "x lies on the same side of the old mean and of the new one: no product of the two "
                "deviations is negative");
  }
  expect_hard_variance(rng, {variance_by_welford, one_pass_floor, hints, because_one_pass});
}

TEST_CASE("1.4 Welford survives a stream of 1e8 values", "[1.4][points:3][slow]") {
  // Exact: the pattern {4, 7, 13, 16} has mean 10 and m2 90, and 4 divides the count.
  constexpr std::uint64_t count = 100'000'000;
  const sandbox::Limits patient{.cpu_seconds = 8, .wall_seconds = 30};
  const auto got = MEASURE_WITH(patient, stream, count, 0.0);
  expect_that(got.value.count == count, fmt::format("{}.count = {}", got.call, got.value.count),
              fmt::format("{}", count), "",
              "a float counts to 2^24 only: a double, or a whole number");
  // The mean's updates shrink as 1/count while each rounding stays eps * 10: they add up to eps *
  // sqrt(n) if they scatter, 11.6 digits; 12.6 were measured. The same for m2 (15.9 measured).
  const std::string because =
      "1e8 roundings that scatter add up to 1e4 eps: 11.6 digits, less room";
  const Hints hints{{},
                    "if short lists are right: is anything a float? Does anything grow with the "
                    "count that need not?",
                    late_count};
  expect_digits(got.call + ".mean", got.value.mean, 10, 11.6 - room, because, hints);
  expect_digits(got.call + ".m2", got.value.m2, 22.5 * 1e8, 11.6 - room, because, hints);
}

// 1.5 ---------------------------------------------------------------------------------------------

ExactMoments exact_merge(const Moments& a, const Moments& b) {
  const Exact n_a(static_cast<double>(a.count)), n_b(static_cast<double>(b.count));
  const Exact n = n_a + n_b;
  const Exact apart = Exact(b.mean) - Exact(a.mean);
  ExactMoments all;
  all.count = static_cast<double>(n);
  all.mean = Exact(a.mean) + apart * n_b / n;
  all.m2 = Exact(a.m2) + Exact(b.m2) + apart * apart * n_a / n * n_b;
  return all;
}

void expect_merge(const Moments& a, const Moments& b) {
  const auto got = MEASURE(merge, a, b);
  const auto exact = exact_merge(a, b);
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  const double n = n_a + n_b;
  const double apart = b.mean - a.mean;
  const double mean = static_cast<double>(exact.mean);
  const auto whole_product = static_cast<double>(a.count * b.count);
  const std::string because = "a dozen operations, each rounded once";
  expect_that(got.value.count == a.count + b.count,
              fmt::format("{}.count = {}", got.call, got.value.count),
              fmt::format("{}", a.count + b.count), "", "the counts add up");
  expect_within(got.call + ".mean", got.value.mean, mean,
                16 * eps * std::max(std::abs(a.mean), std::abs(b.mean)), because,
                {{{(a.mean + b.mean) / 2, "the mean of two means is right only for equal counts"}},
                 "means count by their shares: (n_a mean_a + n_b mean_b) / (n_a + n_b)",
                 empty_part});
  // apart is a difference of two means as they are: exact enough in itself.
  expect_within(
      got.call + ".m2", got.value.m2, static_cast<double>(exact.m2),
      64 * eps * static_cast<double>(exact.m2), because,
      {{{a.m2 + b.m2,
         "two parts with different means vary between them too: (mean_b - mean_a)^2 "
         "n_a n_b / n is missing"},
        {a.m2 + n_a * (a.mean - mean) * (a.mean - mean) +  //
             b.m2 + n_b * (b.mean - mean) * (b.mean - mean),
         "both parts were measured from the merged mean, which is rounded: (mean_b - mean_a)^2 "
         "n_a n_b / n needs no third mean"},
        {a.m2 + b.m2 + apart * apart * whole_product / n,
         "the counts were multiplied as 64-bit whole numbers, and overflowed: multiply doubles"},
        {a.m2 + b.m2 + apart * apart, "the square of the distance wants its weight n_a n_b / n"},
        {a.m2 + b.m2 + apart * apart * n_a * n_b, "n_a n_b is still to be divided by n_a + n_b"}},
       "a.m2 + b.m2 + (mean_b - mean_a)^2 n_a n_b / n; do the counts multiply beyond 64 bits?",
       empty_part});
}

TEST_CASE("1.5 merging two parts equals adding all values", "[1.5][points:5]") {
  Rng rng = check_rng();
  for (int i = 0; i < 5; ++i) {
    expect_merge({1 + rng() % 100, uniform(rng, -9, 9), uniform(rng, 0, 99)},
                 {1 + rng() % 100, uniform(rng, -9, 9), uniform(rng, 0, 99)});
  }
  expect_merge({1, uniform(rng, -9, 9), 0}, {1, uniform(rng, -9, 9), 0});
}

TEST_CASE("1.5 parts of real data merge to the whole", "[1.5][points:2][needs:1.4]") {
  Rng rng = check_rng();
  for (const double offset : {0.0, 1e6}) {
    const auto x = shifted_pattern(rng, offset, 1000);
    std::vector<std::uint64_t> sizes{0, 1, rng() % 200, 0, 300, 2};
    sizes.push_back(1000 - std::accumulate(sizes.begin(), sizes.end(), std::uint64_t{0}));
    const auto exact = exact_moments(x);
    const auto got = MEASURE(merge_parts, x, sizes);
    expect_moments(
        got.call, got.value, exact, two_pass_floor(1000), one_pass_floor(exact), because_one_pass,
        {{}, "means count by their shares: (n_a mean_a + n_b mean_b) / (n_a + n_b)", empty_part},
        {{},
         "what the parts vary between them, (mean_b - mean_a)^2 n_a n_b / n, is in m2 "
         "too"});
  }
}

TEST_CASE("1.5 merging with an empty part changes nothing", "[1.5][points:3]") {
  Rng rng = check_rng();
  const Moments some{2 + rng() % 100, uniform(rng, -9, 9), uniform(rng, 0, 99)};
  expect_merge(some, {});
  expect_merge({}, some);
  const auto nothing = MEASURE(merge, {}, {});
  expect_that(nothing.value.count == 0 && nothing.value.mean == 0 && nothing.value.m2 == 0,
              nothing.call + " = " + shown(nothing.value), "Moments{}",
              "nothing and nothing is nothing", "0/0 is NaN: look for an empty part first");
}

TEST_CASE("1.5 merging very unequal and very long parts", "[1.5][points:4]") {
  Rng rng = check_rng();
  const double m = uniform(rng, 1, 2);
  const std::uint64_t billion = 1'000'000'000, trillion = billion * 1000;
  expect_merge({billion, m, 0}, {1, 3 * m, 0});
  expect_merge({1, 3 * m, 0}, {billion, m, 0});
  expect_merge({billion, 1e9, 100}, {1, 1e9 + 2, 0});
  expect_merge({billion, m, 5}, {trillion, 2 * m, 7});  // the counts multiply to 1e21 > 2^64
  expect_merge({trillion, m, 1e12}, {1000, m + 1e-7, 1000});
  expect_merge({billion / 2, 1e9, 1}, {billion / 2, 1e9 + 2, 1});
  expect_merge({trillion * 1000, 10, 2.25e16}, {7, 0, 0});
}

// 1.6 ---------------------------------------------------------------------------------------------

Hints covariance_hints(double exact, double n, double scale, const std::string& otherwise) {
  return {{{exact * (n - 1) / n, "this divides by n; a sample covariance divides by n - 1"},
           {exact * (n - 1), "this is the sum of products, not divided yet"},
           {-exact, "the sign is wrong: both deviations are value - mean"},
           {exact / scale, "this is the correlation: do not divide by the deviations"}},
          otherwise};
}

TEST_CASE("1.6 the covariance of pairs", "[1.6][points:6]") {
  Rng rng = check_rng();
  for (const std::size_t n : {2u, 3u, 10u, 1000u}) {
    const auto x = uniform_values(rng, n, -1, 1);
    auto y = uniform_values(rng, n, -1, 1);
    for (std::size_t i = 0; i < n; ++i) y[i] -= 2 * x[i];
    const double exact = static_cast<double>(exact_codeviation(x, y)) / static_cast<double>(n - 1);
    const auto size = static_cast<double>(n);
    const double scale = std::sqrt(exact_moments(x).variance * exact_moments(y).variance);
    const auto got = MEASURE(covariance, x, y);
    // E{XY} - E{X}E{Y} may be used for tame data: kappa is below 30 for any of these but n = 2.
    expect_within(
        got.call, got.value, exact, 100 * size * eps * (scale + 1),
        "n additions lose at most n eps of the sum of products",
        covariance_hints(exact, size, scale, "sum (x - mean x)(y - mean y) and divide by n - 1"));
  }
  const auto one = MEASURE(covariance, {1.5}, {2.5});
  expect_nan(one.call, one.value,
             "there is no sample covariance of fewer than two pairs; " + because_undefined);
  expect_invalid_argument(MEASURE_OUTCOME(covariance, {1, 2, 3}, {1, 2}), "x|y",
                          "there are no pairs where the sizes differ");
}

TEST_CASE("1.6 the covariance keeps its digits under large means", "[1.6][points:4]") {
  Rng rng = check_rng();
  for (const double offset : {1e6, 1e9, 1e12}) {
    const auto x = shifted_pattern(rng, offset, 1000);
    auto y = shifted_pattern(rng, offset, 1000);
    for (std::size_t i = 0; i < x.size(); ++i) y[i] += 2 * (x[i] - offset);
    const double exact = static_cast<double>(exact_codeviation(x, y)) / 999;
    const auto moments_x = exact_moments(x), moments_y = exact_moments(y);
    const double kappa = condition(moments_x) + condition(moments_y);
    const double scale = std::sqrt(moments_x.variance * moments_y.variance);
    const auto got = MEASURE(covariance, x, y);
    // Any way that knows the means, in one pass or two; x and y correlate, so scale is about exact.
    expect_digits(got.call, got.value, exact, floor_of(1000 * kappa * eps), because_one_pass,
                  covariance_hints(
                      exact, 1000, scale,
                      "E{XY} - E{X}E{Y} is the textbook formula again: subtract the means first"));
  }
}

// 1.7 ---------------------------------------------------------------------------------------------

/// p(x,y) - p(x) p(y) of every cell, by the definition. A total other than the table's own shows
/// what becomes of weights that were not normalised.
Values differences(const Values& joint, std::size_t columns, double total) {
  const std::size_t rows = joint.size() / columns;
  Values all;
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) {
      double p_row = 0, p_column = 0;
      for (std::size_t i = 0; i < columns; ++i) p_row += joint[r * columns + i] / total;
      for (std::size_t i = 0; i < rows; ++i) p_column += joint[i * columns + c] / total;
      all.push_back(joint[r * columns + c] / total - p_row * p_column);
    }
  }
  return all;
}
double largest_size(const Values& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

void expect_dependence(const Values& joint, std::size_t columns, double exact, double tolerance,
                       const std::string& because) {
  const double total = std::accumulate(joint.begin(), joint.end(), 0.0);
  const Values right = differences(joint, columns, total);
  const auto [least, most] = std::minmax_element(right.begin(), right.end());
  double of_filled_cells = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    if (joint[i] > 0) of_filled_cells = std::max(of_filled_cells, std::abs(right[i]));
  }
  const bool is_in_empty_cell = of_filled_cells < largest_size(right);
  const std::string one_side =
      is_in_empty_cell && of_filled_cells == *most
          ? "the largest difference is in an empty cell: that counts too, and is below 0, so abs()"
          : "a cell may hold too little as well as too much: abs() is missing";
  const auto got = MEASURE(dependence, joint, columns);
  expect_within(
      got.call, got.value, exact, tolerance, because,
      {{{largest_size(differences(joint, columns, 1)),
         "the weights are no probabilities yet: divide by their total"},
        {largest_size(differences(joint, joint.size() / columns, total)),
         "rows and columns are swapped: cell i is in row i / columns and in column i % columns"},
        {*most, one_side},
        {-*least, one_side},
        {of_filled_cells, "every cell counts, also the empty ones"}},
       "p(x) sums a row over its columns, p(y) a column over its rows, both of weights over their "
       "total; the largest |p(x,y) - p(x)p(y)|"});
}

TEST_CASE("1.7 the dependence of a joint table", "[1.7][points:4]") {
  Rng rng = check_rng();
  const auto judge = [](const Values& joint, std::size_t columns) {
    const double total = std::accumulate(joint.begin(), joint.end(), 0.0);
    expect_dependence(joint, columns, largest_size(differences(joint, columns, total)), 32 * eps,
                      "probabilities of at most 1, added and multiplied a few times");
  };
  for (const auto& [rows, columns] : {std::pair{1u, 3u}, {2u, 2u}, {3u, 5u}, {7u, 2u}}) {
    judge(uniform_values(rng, rows * columns, 0, uniform(rng, 0.1, 50)), columns);
  }
  // The largest difference once below 0 (an empty cell among others that are alike) and once above.
  for (const double odd_one : {0.0, 10.0}) {
    auto joint = uniform_values(rng, 15, 1, 1.1);
    joint[rng() % joint.size()] = odd_one;
    judge(joint, 5);
  }
  expect_invalid_argument(MEASURE_OUTCOME(dependence, {1, 1, 1, 1}, 0), "columns",
                          "a table has at least one column");
  expect_invalid_argument(MEASURE_OUTCOME(dependence, {1, 1, 1, 1, 1}, 2), "joint|columns",
                          "five weights are no table of two columns");
}

TEST_CASE("1.7 independent variables have dependence zero", "[1.7][points:3]") {
  Rng rng = check_rng();
  const double weight = uniform(rng, 1, 9);  // beside it, so that 0 is no answer
  const auto tied = MEASURE(dependence, {weight, 0, 0, weight}, 2);
  expect_within(tied.call, tied.value, 0.25, 8 * eps,
                "p(x,y) = 1/2 on the diagonal, p(x) p(y) = 1/4",
                {{}, "see the first check of this task"});
  for (int i = 0; i < 3; ++i) {
    // Whole weights below 2^20 multiply and add exactly: this table is independent in double too.
    Values joint;
    const std::size_t rows = 2 + rng() % 4, columns = 2 + rng() % 4;
    Values of_row(rows), of_column(columns);
    for (double& weight : of_row) weight = 1 + static_cast<double>(rng() % 1000);
    for (double& weight : of_column) weight = 1 + static_cast<double>(rng() % 1000);
    for (const double row : of_row) {
      for (const double column : of_column) joint.push_back(row * column);
    }
    expect_dependence(joint, columns, 0, 4 * eps, "p(x,y) = p(x) p(y) for every x and y here");
  }
}

TEST_CASE("1.7 the circle is uncorrelated and yet dependent", "[1.7][points:2][needs:1.6]") {
  Rng rng = check_rng();
  const double r = uniform(rng, 1, 9);
  const auto covariance = MEASURE(covariance, {r, 0, -r, 0}, {0, r, 0, -r});
  expect_within(covariance.call, covariance.value, 0, 8 * eps * r * r,
                "four points on a circle: x knows nothing linear about y", {{}, "see 1.6"});
  // The same four points as a table over x, y in {-r, 0, r}: p(0,0) = 0, but p(0) p(0) = 1/4.
  const double w = uniform(rng, 1, 9);
  expect_dependence({0, w, 0, w, 0, w, 0, w, 0}, 3, 0.25, 8 * eps,
                    "at the centre p(x,y) = 0, while p(x) p(y) = 1/2 * 1/2");
}

TEST_CASE("1.7 what is no distribution is refused", "[1.7][points:1]") {
  expect_dependence({2, 0, 0, 2}, 2, 0.25, 8 * eps,
                    "p(x,y) = 1/2 on the diagonal, p(x) p(y) = 1/4; a cell may well be empty");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_invalid_argument(MEASURE_OUTCOME(dependence, {1, -1, 1, 1}, 2), "joint|weight|negative",
                          "no probability is negative");
  expect_invalid_argument(MEASURE_OUTCOME(dependence, {1, nan, 1, 1}, 2), "joint|weight|NaN",
                          "NaN is no probability");
  expect_invalid_argument(MEASURE_OUTCOME(dependence, {0, 0, 0, 0}, 2), "joint|total",
                          "nothing cannot be normalised");
  expect_invalid_argument(MEASURE_OUTCOME(dependence, {}, 2), "joint|total",
                          "nothing cannot be normalised");
}

// 1.8 ---------------------------------------------------------------------------------------------

void expect_fast(const std::string& name, const Values& x, double m2_floor,
                 const std::string& because, const std::string& otherwise) {
  const auto exact = exact_moments(x);
  const auto got = MEASURE(moments, x);
  const Hints mean_hints{
      {},
      digits(got.value.mean, static_cast<double>(exact.mean)) < 1
          ? "the mean is nowhere near: was the shift put back, does each part count by its share?"
          : otherwise};
  const double n = exact.count;
  const Hints m2_hints{
      {{exact.variance, "m2 is a sum: variance() divides it, once"},
       {textbook_from_means(x) * (n - 1), large_numbers},
       {textbook_from_sums(x) * (n - 1), large_numbers},
       {welford_here(x).m2, "these are the digits of a running mean, rounded at every step"}},
      otherwise};
  expect_moments(name.empty() ? got.call : got.call + ", " + name, got.value, exact,
                 std::min(two_pass_floor(x.size()), 13.5), m2_floor, because, mean_hints, m2_hints);
}

TEST_CASE("1.8 the moments of a list of any length", "[1.8][points:5]") {
  Rng rng = check_rng();
  const auto none = MEASURE(moments, {});
  expect_that(none.value.count == 0 && none.value.mean == 0 && none.value.m2 == 0,
              none.call + " = " + shown(none.value), "Moments{}", "there are no values",
              "nothing to add, nothing to divide by");
  // Lengths are judged here, digits below: a value too many or too few changes m2 by a part 1/n.
  const auto judge = [&](std::size_t n) {
    const auto x = tame_values(rng, n, 1, 2);
    const double kappa = condition(exact_moments(x));
    expect_fast("", x, floor_of(static_cast<double>(n) * eps * kappa * kappa),
                "even E{X^2} - E{X}^2 loses no more than n eps E{X^2} / Var{X}",
                "does every value count once, also those in a last, shorter block? Is any sum a "
                "float?");
  };
  for (const std::size_t n : {1u, 2u, 3u, 7u, 31u, 64u, 1000u, 1023u, 1025u, 4096u, 10007u}) {
    judge(n);
  }
  judge(50 + rng() % 2000);
}

/// As many digits as 1.3 keeps, 15 at most, less a digit and a half. What 1.3 keeps is measured,
/// but not taken at more than n roundings leave that scatter, sqrt(n) eps: beyond that it was luck,
/// which is no standard for another order of additions. (n equal roundings lose n/4 eps: for the
/// values here that can repeat, n < 5000, this is within the digit and a half.)
void expect_digits_of_two_passes(const std::string& name, const Values& x,
                                 const std::string& otherwise) {
  const double best = std::min({digits(two_pass_here(x), exact_moments(x).variance), 15.0,
                                -std::log10(std::sqrt(static_cast<double>(x.size())) * eps)});
  expect_fast(name, x, best - 1.5,
              fmt::format("two passes keep {:.1f} digits here; 1.5 may be lost", best), otherwise);
}

TEST_CASE("1.8 the moments keep their digits on hard data", "[1.8][points:5]") {
  Rng rng = check_rng();
  const std::string rounded_means =
      "block means are rounded before they are compared: carry them as offsets from one shift near "
      "the data, in double";
  for (const int number : {1, 2, 3, 4}) {
    expect_digits_of_two_passes(fmt::format("NIST's NumAcc{}", number), numacc(number, rng),
                                rounded_means);
  }
  for (const double offset : {1e6, 1e9, 1e12, 1e15}) {
    expect_digits_of_two_passes("", shifted_pattern(rng, offset, 4096), rounded_means);
  }
  for (const bool comes_first : {true, false}) {
    Values outlier = uniform_values(rng, 100000, 0, 1);
    outlier[comes_first ? 0 : rng() % outlier.size()] = 1e9;
    expect_digits_of_two_passes(
        comes_first ? "an outlier comes first" : "one outlier", outlier,
        "the first value may lie far from all others: shift by a mean of values spread over the "
        "data");
  }
  Values trend = uniform_values(rng, 100000, 0, 1);
  for (std::size_t i = 0; i < trend.size(); ++i) trend[i] += static_cast<double>(i);
  expect_digits_of_two_passes("a trend", trend, "a shift must be near all of the data");
  Values sorted = uniform_values(rng, 10000, 1e9, 1e9 + 1);
  std::sort(sorted.begin(), sorted.end());
  expect_digits_of_two_passes("sorted", sorted, rounded_means);
  for (const Values& x : beyond_double) {
    const auto overflow = MEASURE(moments, x);
    expect_overflow(overflow.call + ".m2", overflow.value.m2);
  }
}

}  // namespace
}  // namespace mc::checks
