// What lab 2 checks. What can be judged exactly is: the points and values that one estimate saw
// tell what it must come to. What is random is judged against exact means and variances, with fresh
// integrands scale · g + offset and fresh seeds in every run.

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "2-independent/experiments.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/expect.hpp"
#include "checks/support/measure.hpp"
#include "checks/support/population.hpp"
#include "checks/support/rect_light_exact.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;
using experiments::Function;
using experiments::Sampling;
using experiments::Trace;

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double denormal = std::numeric_limits<double>::denorm_min();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Of each random test. There are 39 of them in this lab, so their sum is 3.9e-7: a factor of
/// nearly three below 1e-6 for what is not exactly Gaussian about a mean of a thousand values.
constexpr double alpha = 1e-8;

/// The integrands of experiments.hpp.
enum : unsigned { constant, exponential, product, step, power, peak, normal, gamma, five };

/// g with a scale and an offset that nobody knows beforehand.
Function fresh(unsigned g, Rng& rng, double parameter = 0) {
  return {g, parameter, uniform(rng, 0.5, 4), uniform(rng, -3, 3)};
}

Population transformed(const Population& x, const Function& function) {
  return transformed(x, function.scale, function.offset);
}

Population of_exponential() {  // exp(U): E{exp(kU)} = (e^k - 1) / k
  const auto moment = [](double k) { return std::expm1(k) / k; };
  return population(moment(1), moment(2), moment(3), moment(4));
}
Population of_product() {  // UV: 1 / (k + 1)^2
  return population(1.0 / 4, 1.0 / 9, 1.0 / 16, 1.0 / 25);
}
Population of_step(double p) {
  return population(p, p, p, p);
}

Values values_of(const std::vector<Estimate>& estimates) {
  Values all;
  for (const Estimate& estimate : estimates) all.push_back(estimate.value);
  return all;
}

void require_size(const std::string& call, std::size_t got, std::size_t expected) {
  if (got == expected) return;
  expect_that(false, fmt::format("{} gave {} values", call, got), fmt::format("{}", expected), "",
              "");
}

/// 2.1 to 2.3 give a value for each argument: a rule that a mistake follows, and what to say then.
struct Rule {
  std::function<double(double)> value;
  std::string hint;
};

/// `got[i]` is `exact(x[i])` within `tolerance(x[i])`. `name` is that of the argument.
void expect_each(const std::string& call, const std::string& name, const Values& x,
                 const Values& got, const std::function<double(double)>& exact,
                 const std::function<double(double)>& tolerance, const std::string& because,
                 const std::vector<Rule>& rules, const std::string& otherwise) {
  require_size(call, got.size(), x.size());
  const auto is = [&](std::size_t i, double value) {
    return got[i] == value || std::abs(got[i] - value) <= 1e-13 * std::abs(value);
  };
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double right = exact(x[i]);
    if (got[i] == right || std::abs(got[i] - right) <= tolerance(x[i])) continue;
    std::string hint = otherwise;
    for (const Rule& rule : rules) {
      std::size_t matches = 0;
      for (std::size_t k = 0; k < x.size(); ++k) matches += is(k, rule.value(x[k])) ? 1 : 0;
      if (matches * 10 < x.size() * 9) continue;  // a few may round in another way
      hint = rule.hint;
      break;
    }
    expect_that(false, fmt::format("{} at {} = {}: {}", call, name, x[i], got[i]),
                fmt::format("{}, give or take {:.2g}", right, tolerance(x[i])), because, hint);
  }
  pass();
}

// 2.1 ---------------------------------------------------------------------------------------------

TEST_CASE("2.1 the upper 53 bits of a word become a number", "[2.1][points:5]") {
  Rng rng = check_rng();
  std::vector<std::uint64_t> words{0, 1, 2047, 2048, 2049, std::uint64_t{1} << 63};
  for (int i = 0; i < 1000; ++i) words.push_back(rng() >> (rng() % 53));
  const auto got = MEASURE(to_unit, words);
  require_size(got.call, got.value.size(), words.size());

  using Bits = std::uint64_t;
  const auto as_double = [](Bits bits) { return static_cast<double>(bits); };
  const std::pair<std::function<double(Bits)>, const char*> rules[] = {
      {[&](Bits bits) { return as_double(bits) * 0x1p-64; },
       "a word has 64 bits and a double 53: bits / 2^64 is rounded, for the largest words up to 1. "
       "Shift 11 bits out first"},
      {[&](Bits bits) { return as_double(bits) / 0x1.fffffffffffffp63; },
       "dividing by the largest word makes 1 a possible number"},
      {[&](Bits bits) { return as_double(bits >> 11) / (0x1p53 - 1); },
       "dividing by 2^53 - 1 makes 1 a possible number: divide by 2^53"},
      {[&](Bits bits) { return as_double(bits >> 12) * 0x1p-52; }, "these are 52 bits; 53 fit"},
      {[&](Bits bits) { return as_double(bits >> 32) * 0x1p-32; },
       "these are 32 bits: too few to tell 10^-10 from 0"},
      {[&](Bits bits) { return as_double(bits & 0x1fffffffffffffu) * 0x1p-53; },
       "these are the lower 53 bits; of many generators the upper ones are the better ones"}};
  for (std::size_t i = 0; i < words.size(); ++i) {
    const double exact = as_double(words[i] >> 11) * 0x1p-53;
    if (got.value[i] == exact) continue;
    std::string hint = "floor(bits / 2^11) times 2^-53; both steps are exact";
    for (const auto& [rule, words_of_it] : rules) {
      bool follows = true;
      for (std::size_t k = 0; k < words.size(); ++k) follows &= got.value[k] == rule(words[k]);
      if (follows) hint = words_of_it;
    }
    expect_that(false, fmt::format("to_unit({}) = {}", words[i], got.value[i]),
                fmt::format("{}", exact), "a shift, a conversion of 53 bits and a power of two",
                hint);
  }
  pass();
}

TEST_CASE("2.1 no word becomes one", "[2.1][points:3]") {
  const std::uint64_t ones = ~std::uint64_t{0};
  std::vector<std::uint64_t> words{0};
  for (std::uint64_t below = 0; below < 4096; below += 61) words.push_back(ones - below);
  const auto got = MEASURE(to_unit, words);
  require_size(got.call, got.value.size(), words.size());
  for (std::size_t i = 0; i < words.size(); ++i) {
    const double least = i == 0 ? 0 : 0.99;
    expect_that(got.value[i] >= least && got.value[i] < 1,
                fmt::format("to_unit({}) = {}", words[i], got.value[i]),
                i == 0 ? "0" : "nearly 1, and never 1",
                "tables have no entry at 1, logarithms no value at 1 - 1",
                "2^53 - 1 over 2^53 is the largest: is something rounded on the way?");
  }
}

// 2.2 ---------------------------------------------------------------------------------------------

TEST_CASE("2.2 exactly n evaluations inside the unit cube", "[2.2][points:4][needs:2.1]") {
  Rng rng = check_rng();
  for (const auto& [g, dims] :
       {std::pair<unsigned, std::size_t>{exponential, 1}, {product, 2}, {five, 5}}) {
    for (const std::uint64_t n : {1u, 2u, 3u, 100u, 1000u}) {
      const auto got = MEASURE(trace, fresh(g, rng), n, rng());
      const Trace& seen = got.value;
      expect_that(seen.values.size() == n,
                  fmt::format("{} evaluated g {} times", got.call, seen.values.size()),
                  fmt::format("{}", n), "n is what the caller pays for",
                  seen.values.size() + 1 == n   ? "one is missing: does the loop begin at 1?"
                  : seen.values.size() == n + 1 ? "one too many: does the loop end at i <= n?"
                                                : "evaluate g once a sample and keep its value");
      require_size(got.call + ", coordinates", seen.points.size(), n * dims);
      const auto outside = std::find_if(seen.points.begin(), seen.points.end(),
                                        [](double u) { return !(u >= 0 && u < 1); });
      expect_that(outside == seen.points.end(),
                  outside == seen.points.end()
                      ? ""
                      : fmt::format("{} evaluated g at a coordinate {}", got.call, *outside),
                  "coordinates in [0, 1)", "", "each coordinate is to_unit() of a word of its own");
      expect_that(seen.estimate.n == n, fmt::format("{}: n = {}", got.call, seen.estimate.n),
                  fmt::format("{}", n), "n counts evaluations", "every sample counts once");
    }
  }
  expect_invalid_argument(MEASURE_OUTCOME(estimates, fresh(exponential, rng), 0, 1, 1), "n",
                          "the mean of nothing is no estimate");
}

/// Ends the check where there are too few values for what is expected of them.
void require_evaluations(const std::string& call, const Trace& seen, std::size_t least) {
  if (seen.values.size() >= least && !seen.points.empty()) return;
  expect_that(false, fmt::format("{} evaluated g {} times", call, seen.values.size()),
              fmt::format("{} evaluations, at least", least), "an estimate rests on values of g",
              "evaluate g once a sample and keep its value");
}

const std::string because_of_sums =
    "n additions lose at most n eps of the sum of sizes, in any order; a digit is left beyond that";

TEST_CASE("2.2 the estimate is the mean of its values", "[2.2][points:4]") {
  Rng rng = check_rng();
  for (const unsigned g : {exponential, product, normal}) {
    for (const std::uint64_t n : {1u, 2u, 10u, 1000u}) {
      const auto got = MEASURE(trace, fresh(g, rng), n, rng());
      const Values& values = got.value.values;
      require_evaluations(got.call, got.value, 1);
      const double mean = static_cast<double>(exact_mean(values));
      double sizes = 0;
      for (const double value : values) sizes += std::abs(value) / static_cast<double>(n);
      const auto size = static_cast<double>(n);
      expect_within(got.call + ".value", got.value.estimate.value, mean, 10 * size * eps * sizes,
                    because_of_sums,
                    {{{mean * size, "this is the sum: divide it by n"},
                      {mean * size / (size - 1), "this divides by n - 1; only a variance does"},
                      {mean * size / (size + 1), "this divides by n + 1"}},
                     "the mean of the very values that g gave"});
    }
  }
}

/// The standard error of `seen` is s / sqrt(n) of its values, with the digits that a one-pass
/// variance keeps (lab 1): (n + kappa) eps of s^2 are lost, and a digit is left beyond that.
void expect_standard_error(const std::string& call, const Trace& seen) {
  require_evaluations(call, seen, 2);
  const auto exact = exact_moments(seen.values);
  const double n = exact.count, s = std::sqrt(exact.variance);
  const double mean = static_cast<double>(exact.mean);
  const double kappa = std::sqrt(1 + mean * mean / exact.variance);
  expect_digits(
      call + ".standard_error", seen.estimate.standard_error, s / std::sqrt(n),
      std::min(16.0, -std::log10((n + kappa) * eps)) - 1,
      fmt::format("the {} values have s = {:.6g}; lab 1's variances keep so many digits", n, s),
      {{{s * s / n, "this is the variance of the mean: take the square root"},
        {s, "this is s, the spread of one value: the mean of n has s / sqrt(n)"},
        {s / n, "this is s / n: it is the variance that falls as 1 / n, its root as 1 / sqrt(n)"},
        {s / std::sqrt(n) * std::sqrt((n - 1) / n),
         "s^2 has n - 1 below it: the values lie closer to their own mean than to the true one"},
        {s / std::sqrt(n - 1), "s^2 / n, not s^2 / (n - 1): one n - 1 is enough"},
        {std::sqrt(static_cast<double>(exact.m2)), "this is not divided at all"}},
       "the square root of (sample variance / n); are the values far from 0 a problem (lab 1)?"});
}

TEST_CASE("2.2 the standard error is s over root n", "[2.2][points:5]") {
  Rng rng = check_rng();
  for (const unsigned g : {exponential, product, normal}) {
    for (const std::uint64_t n : {2u, 3u, 10u, 1000u}) {
      const auto got = MEASURE(trace, fresh(g, rng), n, rng());
      expect_standard_error(got.call, got.value);
    }
  }
  Function far = fresh(exponential, rng);
  far.offset = uniform(rng, 1e9, 2e9);
  const auto large = MEASURE(trace, far, 1000, rng());
  expect_standard_error(large.call, large.value);

  const auto one = MEASURE(trace, fresh(product, rng), 1, rng());
  expect_nan(one.call + ".standard_error", one.value.estimate.standard_error,
             "one value says nothing about how values vary");
  for (const double c : {3.0, uniform(rng, 0.1, 1e6)}) {
    const auto same = MEASURE(trace, {constant, 0, c, 0}, 1000, rng());
    expect_within(same.call + ".standard_error", same.value.estimate.standard_error, 0,
                  std::sqrt(1000.0) * eps * c,
                  "a constant does not vary: lab 1's variances leave at most (n eps c)^2 of it",
                  {{}, "which variance is this? E{X^2} - E{X}^2 leaves more"});
  }
}

/// Where pairs (x, y) of numbers in [0, 1) fall, in 16 x 16 cells.
std::vector<std::uint64_t> pair_counts(const Values& x, std::size_t first, std::size_t second,
                                       std::size_t stride) {
  std::vector<std::uint64_t> counts(256);
  for (std::size_t i = 0; std::max(first, second) + i < x.size(); i += stride) {
    const double column = std::floor(x[first + i] * 16), row = std::floor(x[second + i] * 16);
    if (!(column >= 0 && column < 16 && row >= 0 && row < 16)) continue;  // judged elsewhere
    ++counts[static_cast<std::size_t>(16 * row + column)];
  }
  return counts;
}

const Values even_cells{1.0 / 256};

TEST_CASE("2.2 the points are uniform and independent", "[2.2][points:3][needs:2.1]") {
  Rng rng = check_rng();
  const Function g = fresh(product, rng);
  const std::uint64_t n = 60000, seed = rng();
  const auto got = MEASURE(trace, g, n, seed);
  const Values& points = got.value.points;
  expect_that(points.size() > n, fmt::format("{} saw {} coordinates", got.call, points.size()),
              "two for each of its points", "", "draw a number for each dimension");
  expect_distribution(got.call + ", coordinates", points, [](double u) { return u; },
                      {"coordinates are uniform and independent", alpha},
                      {{}, "every coordinate is to_unit() of a word of its own"});
  expect_counts(got.call + ", points", pair_counts(points, 0, 1, 2), even_cells,
                {"the two coordinates of a point are independent", alpha},
                {{}, "draw a number for each dimension: one number for both fills a line"});
  expect_counts(got.call + ", neighbours", pair_counts(points, 1, 2, 2), even_cells,
                {"the x of a point knows nothing of the y before it", alpha},
                {{}, "no number is used twice"});
  expect_counts(got.call + ", pairs of points, x and x", pair_counts(points, 0, 2, 4), even_cells,
                {"the x of a point knows nothing of the x before it", alpha},
                {{}, "each point is drawn afresh: neither a copy nor a mirror image of another"});

  const auto again = MEASURE(trace, g, 100, seed), other = MEASURE(trace, g, 100, seed + 1);
  const auto repeated = MEASURE(trace, g, 100, seed);
  expect_that(again.value.points == repeated.value.points,
              again.call + " saw other points when it was repeated", "the same points",
              "the generator it is given is its only source of randomness",
              "no generator of your own, no clock, nothing static");
  expect_that(again.value.points != other.value.points,
              other.call + " saw the points of the seed before it", "other points",
              "the generator it is given is its only source of randomness",
              "take the numbers from rng");
}

/// Estimates of a smooth integrand, one after the other from one generator, all differ.
void expect_new_numbers(const std::string& call, const Values& estimates) {
  for (std::size_t i = 1; i < estimates.size(); ++i) {
    expect_that(estimates[i] != estimates[i - 1],
                fmt::format("{}: two estimates in a row are {}", call, estimates[i]),
                "estimates that differ", "each goes on where the generator was left",
                "the generator must move on: is it copied somewhere?");
  }
}

TEST_CASE("2.2 the estimate is unbiased with variance sigma^2 over n",
          "[2.2][points:4][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 64, replicates = 400;
  const double p = uniform(rng, 0.2, 0.8);
  const std::pair<Function, Population> cases[] = {{fresh(exponential, rng), of_exponential()},
                                                   {fresh(product, rng), of_product()},
                                                   {fresh(step, rng, p), of_step(p)}};
  for (const auto& [g, x] : cases) {
    const auto got = MEASURE(estimates, g, n, rng(), replicates);
    require_size(got.call, got.value.size(), replicates);
    const Values values = values_of(got.value);
    if (g.g != step) expect_new_numbers(got.call, values);
    const Population truth = transformed(x, g);
    const Known known = mean_of(truth, n);
    const std::string name = g.g == exponential ? "exp(x)" : g.g == product ? "x y" : "a step";
    expect_mean({got.call, values, n}, known.exact, known.variance,
                {"estimates of " + name + " have the mean E{g}", alpha},
                {{{g.scale / 3 + g.offset, "that is the mean of x^2: one number for both x and y"},
                  {truth.mean * (n - 1) / n, "one of n samples is missing"},
                  {truth.mean * n, "divide by n"}},
                 "the mean of g at uniform points, nothing else"});
    expect_variance({got.call, values, n}, known.exact, known.variance, known.kurtosis,
                    {"estimates of " + name + " have the variance Var{g} / n", alpha},
                    {{{n, "each estimate is as bad as a single sample: are its points different?"},
                      {2, "as if only half of the samples counted"}},
                     "n independent points, and estimates that have nothing in common"});
  }
}

TEST_CASE("2.2 the error falls as one over root n", "[2.2][points:2][needs:2.1]") {
  Rng rng = check_rng();
  const Function g = fresh(exponential, rng);
  const std::uint64_t few = 16, many = 1024, replicates = 400;
  const auto at_few = MEASURE(estimates, g, few, rng(), replicates);
  const auto at_many = MEASURE(estimates, g, many, rng(), replicates);
  const Population truth = transformed(of_exponential(), g);
  const Values few_values = values_of(at_few.value), many_values = values_of(at_many.value);
  expect_new_numbers(at_few.call, few_values);
  expect_rate({at_few.call, few_values, few}, mean_of(truth, few),
              {at_many.call, many_values, many}, mean_of(truth, many),
              {"the error of independent samples falls as N^-1/2", alpha},
              {{{0, "more samples change nothing: are they the same ones again?"},
                {1, "faster than independent samples can: these are not"}},
               "n independent samples, every one of them new"});
}

TEST_CASE("2.2 rare events and a narrow peak", "[2.2][points:3][needs:2.1]") {
  Rng rng = check_rng();
  // An event of probability p: n times the estimate is how often it happened.
  for (const auto& [p, n] : {std::pair<double, std::uint64_t>{uniform(rng, 0.5e-4, 2e-4), 10000},
                             {uniform(rng, 2e-6, 4e-6), 40000}}) {
    const std::uint64_t replicates = 100;
    const Function g = fresh(step, rng, p);
    const auto got = MEASURE(estimates, g, n, rng(), replicates);
    double happened = 0;
    for (const Estimate& one : got.value) {
      const double times = (one.value - g.offset) / g.scale * static_cast<double>(n);
      expect_within(got.call + ": (value - offset) n / scale", times, std::round(times), 1e-6,
                    "an event happens a whole number of times", {{}, "see 2.2: the mean"});
      happened += std::round(times);
    }
    expect_that(happened >= 0 && happened <= static_cast<double>(n * replicates),
                fmt::format("{}: {} events", got.call, happened), "a number that can be", "", "");
    expect_proportion(got.call, fmt::format("x < {:.3g}", p), static_cast<std::uint64_t>(happened),
                      n * replicates, p,
                      {p > 1e-5 ? "events of probability 1e-4 happen as often as they should"
                                : "events of probability 1e-6 happen as often as they should",
                       alpha},
                      {{}, "how many different numbers can to_unit() make near 0?"});
  }
  // A peak of width s: E{g^k} = 2 pi s^2 / k, but for what the edges cut off.
  const double s = uniform(rng, 0.015, 0.03);
  const auto moment = [&](double k) {
    const double width = s / std::sqrt(k);
    const auto share = [&](double centre) {
      return 1 - normal_tails(-centre / width).lower - normal_tails((1 - centre) / width).upper;
    };
    return 2 * std::numbers::pi * width * width * share(0.3) * share(0.7);
  };
  const std::uint64_t n = 5000, replicates = 200;
  const Function g = fresh(peak, rng, s);
  const auto got = MEASURE(estimates, g, n, rng(), replicates);
  const Known known =
      mean_of(transformed(population(moment(1), moment(2), moment(3), moment(4)), g), n);
  const Values values = values_of(got.value);
  expect_new_numbers(got.call, values);
  expect_mean({got.call, values, n}, known.exact, known.variance,
              {"estimates of a narrow peak have the mean E{g}", alpha},
              {{}, "uniform points, in x and in y"});
}

// 2.3 ---------------------------------------------------------------------------------------------

/// Sorted numbers of [0, 1): ordinary ones, tiny ones, and those that are nearly 1.
Values shares(Rng& rng) {
  Values u{0, denormal, 1e-300, 0x1p-53, 0.5, 1 - 0x1p-53};
  for (int i = 0; i < 500; ++i) {
    u.push_back(uniform(rng));
    u.push_back(std::pow(10, -uniform(rng, 0, 30)));
    u.push_back(1 - std::ldexp(1.0, -1 - static_cast<int>(rng() % 53)));
    u.push_back(std::nextafter(u[u.size() - 3], 1.0));
  }
  std::erase_if(u, [](double value) { return !(value < 1); });
  std::sort(u.begin(), u.end());
  return u;
}

void expect_inversion(const std::string& call, const Values& u, const Values& x, double last) {
  for (std::size_t i = 0; i < u.size(); ++i) {
    expect_that(x[i] >= 0 && x[i] <= last && std::isfinite(x[i]),
                fmt::format("{} at u = {}: {}", call, u[i], x[i]),
                last == 1 ? "a number in [0, 1]" : "a finite number, not negative",
                "every u in [0, 1) has its x in the support", "which u makes this so?");
    if (i == 0) continue;
    // Two neighbouring u may be rounded past each other, by the 4 ulp that each may be off.
    expect_that(
        x[i] >= x[i - 1] * (1 - 8 * eps),
        fmt::format("{}: {} at u = {}, but {} at u = {}", call, x[i - 1], u[i - 1], x[i], u[i]),
        "x that does not fall when u rises",
        "x is where the distribution reaches u: inversion keeps the order",
        "1 - u is as uniform as u, but it turns the order round");
  }
}

TEST_CASE("2.3 exponential samples by inversion", "[2.3][points:4]") {
  Rng rng = check_rng();
  for (const double rate : {1.0, uniform(rng, 0.001, 1), uniform(rng, 1, 1000)}) {
    const Values u = shares(rng);
    const auto got = MEASURE(sample_exponential, u, rate);
    const auto exact = [=](double at) { return -std::log1p(-at) / rate; };
    expect_each(
        got.call, "u", u, got.value, exact,
        [&](double at) { return 4 * eps * exact(at) + denormal; },
        "P(x) = 1 - exp(-rate x) = u, to 4 ulp",
        {{[=](double at) { return -std::log(at) / rate; },
          "this is -log(u) / rate: right on average, but falling in u, and infinite at u = 0"},
         {[=](double at) { return -std::log(1 - at) / rate; },
          "1 - u forgets the last digits of a small u: log1p(-u) does not"},
         {[=](double at) { return -std::log1p(-at) * rate; },
          "divide by the rate: many events a second are short waits"},
         {[=](double at) { return std::log1p(-at) / rate; }, "the sign is wrong: log(1 - u) < 0"},
         {[=](double at) { return -std::log1p(-at); }, "where is the rate?"}},
        "solve 1 - exp(-rate x) = u for x, with log1p");
    expect_inversion(got.call, u, got.value, std::numeric_limits<double>::infinity());
  }
}

TEST_CASE("2.3 power samples by inversion", "[2.3][points:4]") {
  Rng rng = check_rng();
  for (const double a :
       {0.0, 1.0, -0.5, -0.75, -0.99, uniform(rng, -0.9, -0.1), uniform(rng, 0.1, 9)}) {
    const Values u = shares(rng);
    const auto got = MEASURE(sample_power, u, a);
    const auto exact = [=](double at) { return std::pow(at, 1 / (a + 1)); };
    expect_each(
        got.call, "u", u, got.value, exact,
        [&](double at) {  // the exponent is rounded, and so is a logarithm on the way
          const double magnified = at > 0 ? std::abs(std::log(at)) / (a + 1) : 0;
          return 4 * eps * (1 + magnified) * exact(at) + 2 * denormal;
        },
        "P(x) = x^(a+1) = u, to 4 ulp and those of a rounded exponent",
        {{[=](double at) { return std::pow(at, a + 1); },
          "this is P(u): its inverse is u^(1/(a+1))"},
         {[=](double at) { return a == 0 ? nan : std::pow(at, 1 / a); },
          "integrating x^a raises the exponent: 1 / (a + 1)"},
         {[=](double at) { return std::pow(1 - at, 1 / (a + 1)); },
          "1 - u is as uniform as u, but it turns the order round"}},
        "solve x^(a+1) = u for x");
    expect_inversion(got.call, u, got.value, 1);
  }
}

TEST_CASE("2.3 the densities of what is sampled", "[2.3][points:3]") {
  Rng rng = check_rng();
  for (const double rate : {1.0, uniform(rng, 0.001, 1), uniform(rng, 1, 1000)}) {
    Values x{-1, -1e-300, 0, 1 / rate};
    for (int i = 0; i < 100; ++i) x.push_back(uniform(rng, -1, 9) / rate);
    const auto got = MEASURE(pdf_exponential, x, rate);
    const auto exact = [=](double at) { return at < 0 ? 0 : rate * std::exp(-rate * at); };
    expect_each(
        got.call, "x", x, got.value, exact,
        [&](double at) { return 4 * eps * (1 + rate * std::abs(at)) * exact(at); },
        "rate exp(-rate x) for x >= 0, and nothing below",
        {{[=](double at) { return at < 0 ? 0 : std::exp(-rate * at); },
          "a density integrates to 1: the factor rate is missing"},
         {[=](double at) { return rate * std::exp(-rate * at); },
          "the density is 0 where the distribution does not reach"}},
        "the derivative of P(x) = 1 - exp(-rate x)");
  }
  for (const double a : {0.0, 1.0, -0.5, uniform(rng, -0.9, -0.1), uniform(rng, 0.1, 9)}) {
    Values x{-1, -1e-300, 0, 1, std::nextafter(1.0, 2.0), 2};
    for (int i = 0; i < 100; ++i) x.push_back(uniform(rng, -0.5, 1.5));
    const auto got = MEASURE(pdf_power, x, a);
    const auto exact = [=](double at) { return at < 0 || at > 1 ? 0 : (a + 1) * std::pow(at, a); };
    expect_each(
        got.call, "x", x, got.value, exact,
        [&](double at) {
          const double magnified = at > 0 ? std::abs(a * std::log(at)) : 0;
          return 8 * eps * (1 + magnified) * exact(at);
        },
        "(a + 1) x^a on [0, 1], both ends included, and nothing outside",
        {{[=](double at) { return at < 0 || at > 1 ? 0 : std::pow(at, a); },
          "a density integrates to 1: x^a alone gives 1 / (a + 1)"},
         {[=](double at) { return at <= 0 || at >= 1 ? 0 : (a + 1) * std::pow(at, a); },
          "the ends belong to [0, 1]"}},
        "the derivative of P(x) = x^(a+1), and 0 outside [0, 1]");
  }
}

TEST_CASE("2.3 parameters that make no density are refused", "[2.3][points:2]") {
  const auto fine = MEASURE(sample_exponential, {0.5}, 1e-3);
  require_size(fine.call, fine.value.size(), 1);
  expect_digits(fine.call, fine.value[0], std::numbers::ln2 * 1e3, 12, "",
                {{}, "a small rate is fine"});
  const auto steep = MEASURE(sample_power, {0.5}, -0.9375);
  require_size(steep.call, steep.value.size(), 1);
  expect_digits(steep.call, steep.value[0], 0x1p-16, 12, "", {{}, "a > -1 is fine"});
  for (const double rate : {0.0, -1.0, nan}) {
    const std::string because = "a rate is positive";
    expect_invalid_argument(MEASURE_OUTCOME(sample_exponential, {0.5}, rate), "rate", because);
    expect_invalid_argument(MEASURE_OUTCOME(pdf_exponential, {0.5}, rate), "rate", because);
  }
  for (const double a : {-1.0, -2.0, nan}) {
    const std::string because = "x^a has a finite integral over [0, 1] only for a > -1";
    expect_invalid_argument(MEASURE_OUTCOME(sample_power, {0.5}, a), "a", because);
    expect_invalid_argument(MEASURE_OUTCOME(pdf_power, {0.5}, a), "a", because);
  }
}

// 2.4 ---------------------------------------------------------------------------------------------

/// Sampling::p
enum : unsigned { by_uniform, by_power, by_exponential, by_holes };

TEST_CASE("2.4 the mean of g over p at samples of p", "[2.4][points:4][needs:2.1]") {
  Rng rng = check_rng();
  for (const std::uint64_t n : {1u, 2u, 10u, 1000u}) {
    const double a = uniform(rng, -0.6, 2);
    const auto got = MEASURE(importance_trace, fresh(exponential, rng), {by_power, a}, n, rng());
    const Trace& seen = got.value;
    require_size(got.call + ", points", seen.points.size(), seen.values.size());
    expect_that(seen.samples == n && seen.values.size() == n && seen.estimate.n == n,
                fmt::format("{} drew {} points, evaluated g {} times and says n = {}", got.call,
                            seen.samples, seen.values.size(), seen.estimate.n),
                fmt::format("{0}, {0} and {0}", n), "n is what the caller pays for",
                "one point, one value of g for each sample");
    const double mean = static_cast<double>(exact_mean(seen.values));
    double sizes = 0, plain = 0, times = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double density = (a + 1) * std::pow(seen.points[i], a),
                   share = 1.0 / static_cast<double>(n);
      sizes += std::abs(seen.values[i]) * share;
      plain += seen.values[i] * density * share;
      times += seen.values[i] * density * density * share;
    }
    expect_within(
        got.call + ".value", seen.estimate.value, mean,
        10 * (static_cast<double>(n) + 2) * eps * sizes, because_of_sums,
        {{{plain, "this is the mean of g: where p is large, points are many, so each counts 1 / p"},
          {times, "this is the mean of g p: divide by p"},
          {mean * static_cast<double>(n), "this is the sum: divide it by n"}},
         "the mean of g(x) / p(x), x = p.sample(u)"});
    if (n > 1) {
      expect_standard_error(got.call, seen);
    } else {
      expect_nan(got.call + ".standard_error", seen.estimate.standard_error,
                 "one value says nothing about how values vary");
    }
  }
  const double a = uniform(rng, 0.5, 2);
  const auto got = MEASURE(importance_trace, fresh(exponential, rng), {by_power, a}, 20000, rng());
  expect_distribution(got.call + ", points", got.value.points,
                      [=](double x) { return std::pow(std::clamp(x, 0.0, 1.0), a + 1); },
                      {"points of 2.4 are distributed as p", alpha},
                      {{}, "x = p.sample(u), with a new uniform u each time"});
  expect_invalid_argument(
      MEASURE_OUTCOME(importance_estimates, fresh(exponential, rng), {by_uniform, 0}, 0, 1, 1), "n",
      "the mean of nothing is no estimate");
}

TEST_CASE("2.4 the estimate is unbiased with the variance of g over p",
          "[2.4][points:4][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 64, replicates = 400;
  const double scale = uniform(rng, 0.5, 4);

  // x^q by p = (a+1) x^a: weights w = x^(q-a) / (a+1), E{w^k} = (a+1)^(1-k) / (k (q-a) + a + 1).
  // They are bounded for q > a, so that their means are nearly Gaussian.
  const double q = uniform(rng, 0.8, 1.5), a = uniform(rng, -0.6, 0.3);
  const auto power_moment = [&](double k) {
    return std::pow(a + 1, 1 - k) / (k * (q - a) + a + 1);
  };
  // x exp(-x) by p = r exp(-r x): w = x exp(-(1-r) x) / r, E{w^k} = r^(1-k) k! / (k (1-r) +
  // r)^(k+1).
  const double r = uniform(rng, 0.3, 0.8);
  const auto gamma_moment = [&](double k) {
    return std::pow(r, 1 - k) * std::tgamma(k + 1) / std::pow(k * (1 - r) + r, k + 1);
  };
  struct Case {
    Function g;
    Sampling p;
    std::function<double(double)> moment;
    double without_p;  // E{g(x)}, x distributed as p
    std::string name;
  };
  const Case cases[] = {
      {{power, q, scale, 0}, {by_power, a}, power_moment, (a + 1) / (q + a + 1), "a power"},
      {{gamma, 0, scale, 0},
       {by_exponential, r},
       gamma_moment,
       r / ((1 + r) * (1 + r)),
       "x exp(-x)"}};
  for (const Case& one : cases) {
    const auto got = MEASURE(importance_estimates, one.g, one.p, n, rng(), replicates);
    require_size(got.call, got.value.size(), replicates);
    const Values values = values_of(got.value);
    const auto& m = one.moment;
    const Known known = mean_of(transformed(population(m(1), m(2), m(3), m(4)), one.g), n);
    expect_mean({got.call, values, n}, known.exact, known.variance,
                {"importance estimates of " + one.name + " have the mean of the integral", alpha},
                {{{scale * one.without_p, "this is the mean of g: it forgets to divide by p"}},
                 "the mean of g(x) / p(x), x = p.sample(u)"});
    expect_variance(
        {got.call, values, n}, known.exact, known.variance, known.kurtosis,
        {"importance estimates of " + one.name + " have the variance Var{g/p} / n", alpha},
        {{}, "n independent points from p"});
  }
}

TEST_CASE("2.4 the right density cures an infinite variance", "[2.4][points:3][needs:2.1]") {
  Rng rng = check_rng();
  // g = x^-0.75 has the mean 4 and no variance. With p proportional to g every weight is 4.
  const Function g{power, -0.75, uniform(rng, 0.5, 4), 0};
  const auto got = MEASURE(importance_estimates, g, {by_power, -0.75}, 100, rng(), 20);
  require_size(got.call, got.value.size(), 20);
  for (const Estimate& one : got.value) {
    const std::string because =
        "x^-0.75 over its own density is 4 at every x, up to a few roundings of two powers";
    expect_within(got.call + ".value", one.value, 4 * g.scale, 100 * 10 * eps * 4 * g.scale,
                  because, {{}, "the mean of g(x) / p(x), x = p.sample(u)"});
    expect_within(got.call + ".standard_error", one.standard_error, 0, 100 * 10 * eps * 4 * g.scale,
                  because, {{}, "what has no spread has no standard error"});
  }
}

TEST_CASE("2.4 points without a usable density add nothing", "[2.4][points:2][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 1000;
  const double hole = uniform(rng, 0.2, 0.6);
  const Function g = fresh(exponential, rng);
  const auto got = MEASURE(importance_trace, g, {by_holes, hole}, n, rng());
  const Trace& seen = got.value;
  double sum = 0, sizes = 0, counted = 0;
  for (std::size_t i = 0; i < std::min(seen.points.size(), seen.values.size()); ++i) {
    if (!(seen.points[i] >= hole)) continue;
    sum += seen.values[i];
    sizes += std::abs(seen.values[i]);
    ++counted;
  }
  expect_that(
      seen.samples == n && seen.estimate.n == n,
      fmt::format("{} drew {} points and says n = {}", got.call, seen.samples, seen.estimate.n),
      fmt::format("{0} and {0}", n), "a point that adds 0 was paid for all the same",
      "every sample counts, also one of weight 0");
  expect_within(got.call + ".value", seen.estimate.value, sum / static_cast<double>(n),
                10 * eps * sizes,
                fmt::format("the pdf is 0 or infinite for {} of {} points, which add 0 to the sum",
                            static_cast<double>(n) - counted, n),
                {{{sum / counted, "divide by all n samples, not by those that counted"}},
                 "g / 0 is no weight: where the pdf is 0 or infinite, add 0"});
}

// 2.5 ---------------------------------------------------------------------------------------------

TEST_CASE("2.5 a confidence interval of a given level", "[2.5][points:4]") {
  Rng rng = check_rng();
  for (const double level : {0.5, 0.6827, 0.9, 0.95, 0.99, 0.999999, uniform(rng, 0.01, 0.99)}) {
    const Estimate estimate{uniform(rng, -9, 9), uniform(rng, 0.01, 1), 100};
    const auto got = MEASURE(confidence_interval, estimate, level);
    const double z = normal_quantile((1 + level) / 2), reach = z * estimate.standard_error;
    const double one_sided = normal_quantile(level) * estimate.standard_error;
    const double value = estimate.value;
    // 1e-10: (1 - level) / 2 may be formed with one rounding of level, 1e-16 of 5e-7.
    const auto end = [&](const std::string& name, double got_end, double sign) {
      expect_within(
          got.call + "." + name, got_end, value + sign * reach,
          1e-9 * reach + 4 * eps * std::abs(value),
          fmt::format("{:.7g} standard errors to either side leave {:.3g} outside, half of it on "
                      "either side",
                      z, 1 - level),
          {{{value + sign * one_sided,
             "what is left outside lies on both sides: the quantile of (1 + level) / 2"},
            {value + sign * estimate.standard_error, "one standard error covers 68 %, always"},
            {value + sign * 1.96 * estimate.standard_error, "1.96 is for 95 % alone"},
            {value + sign * 2 * estimate.standard_error, "2 is for 95.45 % alone"},
            {value + sign * reach / 10, "standard_error belongs to the mean: it knows n already"},
            {value - sign * reach, "low and high are the wrong way round"}},
           "value ± normal_quantile((1 + level) / 2) standard errors"});
    };
    end("low", got.value.low, -1);
    end("high", got.value.high, 1);
  }
  for (const double level : {0.0, 1.0, -0.5, 1.5, nan}) {
    expect_invalid_argument(MEASURE_OUTCOME(confidence_interval, {1, 0.1, 100}, level), "level",
                            "nothing finite covers with certainty, nothing less than never");
  }
}

/// How many intervals hold the true mean.
std::uint64_t covering(const std::vector<Interval>& intervals, double truth) {
  std::uint64_t count = 0;
  for (const Interval& one : intervals) count += one.low <= truth && truth <= one.high ? 1 : 0;
  return count;
}

TEST_CASE("2.5 intervals of normal samples cover as often as they can",
          "[2.5][points:4][needs:2.1][needs:2.2]") {
  Rng rng = check_rng();
  const std::uint64_t replicates = 4000;
  for (const auto& [n, level] :
       {std::pair<std::uint64_t, double>{5, 0.9}, {20, 0.95}, {100, 0.8}}) {
    const Function g = fresh(normal, rng);
    const auto got = MEASURE(confidence_intervals, g, n, level, rng(), replicates);
    require_size(got.call, got.value.size(), replicates);
    // (mean - truth) / (s / sqrt(n)) of n normal values is Student's t; its square is F(1, n-1).
    const double z = normal_quantile((1 + level) / 2);
    const double exact = f_tails(z * z, 1, static_cast<double>(n - 1)).lower;
    expect_proportion(
        got.call, "the interval held the true mean", covering(got.value, g.offset), replicates,
        exact,
        {fmt::format("intervals of level {} from {} normal samples cover with probability {:.4f}",
                     level, n, exact),
         alpha},
        {{{0, "the intervals hold nothing: are they around the estimate?"}},
         "is the standard error s / sqrt(n), and the quantile that of (1 + level) / 2?"});
  }
}

TEST_CASE("2.5 intervals of rare events cover as rarely as they must",
          "[2.5][points:3][needs:2.1][needs:2.2]") {
  Rng rng = check_rng();
  const std::uint64_t n = 60, replicates = 4000;
  const double level = 0.95;
  for (const double p : {uniform(rng, 0.01, 0.03), uniform(rng, 0.08, 0.2)}) {
    const Function g = fresh(step, rng, p);
    const auto got = MEASURE(confidence_intervals, g, n, level, rng(), replicates);
    require_size(got.call, got.value.size(), replicates);
    // Of n trials k succeed; s^2 = k (n - k) / (n (n - 1)). No success, no spread, no interval.
    const double z = normal_quantile((1 + level) / 2), size = static_cast<double>(n);
    double exact = 0;
    for (std::uint64_t k = 0; k <= n; ++k) {
      const auto successes = static_cast<double>(k);
      const double reach = z * std::sqrt(successes * (size - successes) / (size - 1)) / size;
      if (std::abs(successes / size - p) > reach) continue;
      const Tails here = binomial_tails(k, n, p);
      exact += here.lower + here.upper - 1;
    }
    expect_proportion(
        got.call, "the interval held the true mean", covering(got.value, g.scale * p + g.offset),
        replicates, exact,
        {p < 0.05 ? "intervals of rare events cover as rarely as they must"
                  : "intervals of not so rare events cover as rarely as they must",
         alpha},
        {{},
         "an honest standard error of a rare event is often 0: nothing happened, nothing varies"});
  }
}

// 2.6 ---------------------------------------------------------------------------------------------

TEST_CASE("2.6 the samples that bring the error down", "[2.6][points:6]") {
  Rng rng = check_rng();
  const auto expect_samples = [](const Estimate& pilot, double target) {
    const auto got = MEASURE(samples_for, pilot, target);
    const Exact ratio = Exact(pilot.standard_error) / Exact(target);
    const double n = static_cast<double>(pilot.n);
    const double exact = static_cast<double>(ratio * ratio * Exact(n));
    const double samples = static_cast<double>(got.value);
    const double plain = static_cast<double>(ratio);
    // Rounded up, where the quotient may have gathered 8 roundings: one too many, but never one
    // too few.
    const bool holds = samples >= exact * (1 - 8 * eps) && samples <= exact * (1 + 8 * eps) + 1;
    std::string hint = "n (standard error / target)^2, rounded up";
    const auto about = [&](double suspect) { return std::abs(samples - suspect) <= 1; };
    if (about(exact)) {
      hint = "this many do not quite do it: round up";
    } else if (about(n * plain)) {
      hint = "half the error costs four times the samples: square the ratio";
    } else if (about(plain * plain)) {
      hint = "the pilot's standard error is that of n samples: times n";
    } else if (about(exact - n)) {
      hint = "all of them are asked for, not how many more";
    } else if (about(n / plain / plain)) {
      hint = "the ratio is upside down: a smaller target costs more";
    }
    expect_that(holds, fmt::format("{} = {}", got.call, got.value),
                fmt::format("{:.17g}, rounded up", exact), "the error falls as 1 / sqrt(n)", hint);
  };
  for (int i = 0; i < 10; ++i) {
    const Estimate pilot{uniform(rng, -9, 9), uniform(rng, 0.01, 1), 10 + rng() % 100000};
    expect_samples(pilot, pilot.standard_error / uniform(rng, 1.1, 100));
  }
  expect_samples({1, 0.25, 1000}, 0.125);   // 4000 exactly
  expect_samples({1, 0.5, 1000000}, 1e-4);  // 2.5e13
  expect_samples({1, 0.1, 1000}, 0.7);      // fewer than the pilot had
  expect_samples({-5, 3e150, 17}, 1e149);   // squares that overflow, if taken one by one
}

TEST_CASE("2.6 pilots and targets that say nothing", "[2.6][points:2]") {
  const auto fine = MEASURE(samples_for, {1, 0.5, 100}, 0.25);
  expect_that(fine.value == 400 || fine.value == 401, fmt::format("{} = {}", fine.call, fine.value),
              "400", "half the error costs four times the samples", "see 2.6");
  for (const auto& [error, target] : {std::pair{0.0, 0.1}, {1e-9, 1.0}}) {
    const auto got = MEASURE(samples_for, {1, error, 100}, target);
    expect_that(got.value == 1, fmt::format("{} = {}", got.call, got.value), "1",
                "the target is met already, but without a sample there is no estimate",
                "at least 1");
  }
  for (const double target : {0.0, -0.1, nan}) {
    expect_invalid_argument(MEASURE_OUTCOME(samples_for, {1, 0.5, 100}, target), "target",
                            "a target is positive");
  }
  expect_invalid_argument(MEASURE_OUTCOME(samples_for, {1, nan, 1}, 0.1), "pilot",
                          "a pilot of one sample has no standard error");
  expect_invalid_argument(MEASURE_OUTCOME(samples_for, {0, 0.5, 0}, 0.1), "pilot",
                          "a pilot of no samples knows nothing");
  expect_invalid_argument(MEASURE_OUTCOME(samples_for, {1, 1e6, 1000}, 1e-6),
                          "target|pilot|samples", "1e27 does not fit into 64 bits");
}

// 2.7 ---------------------------------------------------------------------------------------------

/// One light over the receiver, and one anywhere. Not so near that a few points carry everything.
std::vector<RectLight> fresh_lights(Rng& rng) {
  RectLight above, aside;
  above.radiance = uniform(rng, 0.5, 5);
  aside.x0 = uniform(rng, -1.5, 0.5);
  aside.x1 = aside.x0 + uniform(rng, 0.5, 2);
  aside.y0 = uniform(rng, -1.5, 0.5);
  aside.y1 = aside.y0 + uniform(rng, 0.5, 2);
  aside.height = uniform(rng, 0.7, 2);
  aside.radiance = uniform(rng, 0.5, 5);
  return {above, aside};
}

/// What one point of the light gives.
double at_point(const RectLight& light, double x, double y) {
  const double distance2 = x * x + y * y + light.height * light.height;
  return area(light) * light.radiance * light.height * light.height / (distance2 * distance2);
}

Population of_area(const RectLight& light) {
  const auto moment = [&](double k) {
    return mean_over(light, [&](double x, double y) { return std::pow(at_point(light, x, y), k); });
  };
  const double exact = irradiance(light);
  Population x = population(moment(1), moment(2), moment(3), moment(4));
  x.mean = exact;
  return x;
}

TEST_CASE("2.7 irradiance from points on the light", "[2.7][points:4][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 64, replicates = 400;
  for (const RectLight& light : fresh_lights(rng)) {
    const auto got = MEASURE(irradiance_area, light, n, rng(), replicates);
    require_size(got.call, got.value.size(), replicates);
    const Values values = values_of(got.value);
    const Known known = mean_of(of_area(light), n);
    const std::string where = light.x0 == -1 ? "above" : "aside";
    double diagonal = 0;
    for (int i = 0; i < 1000; ++i) {
      const double u = (i + 0.5) / 1000;
      diagonal += at_point(light, light.x0 + u * (light.x1 - light.x0),
                           light.y0 + u * (light.y1 - light.y0)) /
                  1000;
    }
    const double no_distance =
        area(light) * light.radiance * mean_over(light, [&](double x, double y) {
          return light.height * light.height / (x * x + y * y + light.height * light.height);
        });
    expect_mean(
        {got.call, values, n}, known.exact, known.variance,
        {"the area estimate of a light " + where + " has the mean E", alpha},
        {{{without_a_cosine(light), "a cosine is missing: the light, too, is seen at an angle"},
          {known.exact / area(light), "the density of points is 1 / area: the area is missing"},
          {known.exact / light.radiance, "the radiance is missing"},
          {no_distance, "the distance is missing: 1 / distance^2"},
          {diagonal, "x and y come from one number: all points lie on the diagonal"},
          {known.exact / std::numbers::pi, "nothing is divided by pi here"}},
         "area · radiance · cos · cos / distance^2, at uniform points of the light"});
    expect_variance({got.call, values, n}, known.exact, known.variance, known.kurtosis,
                    {"the area estimate of a light " + where + " has its exact variance", alpha},
                    {{}, "n independent points, uniform on the light"});
  }
  expect_invalid_argument(MEASURE_OUTCOME(irradiance_area, {}, 0, 1, 1), "n",
                          "the mean of nothing is no estimate");
}

/// How many of n directions met the light, for each estimate.
Values directions_met(const std::string& call, const std::vector<Estimate>& estimates,
                      const RectLight& light, std::uint64_t n) {
  Values all;
  const double each = std::numbers::pi * light.radiance / static_cast<double>(n);
  for (const Estimate& one : estimates) {
    const double met = one.value / each;
    expect_that(
        std::abs(met - std::round(met)) < 1e-6 && met > -0.5 && met < static_cast<double>(n) + 0.5,
        fmt::format("{} gave {}", call, one.value),
        fmt::format("a multiple of pi · radiance / n = {:.8g}", each),
        "a direction with density cos / pi gives pi · radiance, or nothing",
        "what does a direction count? The cosine and the density cos / pi leave pi");
    all.push_back(std::round(met));
  }
  return all;
}

TEST_CASE("2.7 irradiance from directions of the hemisphere", "[2.7][points:4][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 64, replicates = 400;
  for (const RectLight& light : fresh_lights(rng)) {
    const auto got = MEASURE(irradiance_hemisphere, light, n, rng(), replicates);
    require_size(got.call, got.value.size(), replicates);
    const Values met = directions_met(got.call, got.value, light, n);
    const double all = std::accumulate(met.begin(), met.end(), 0.0);
    const double p = irradiance(light) / (std::numbers::pi * light.radiance);
    const double uniform_share = without_a_cosine(light) / (2 * std::numbers::pi * light.radiance);
    const std::string where = light.x0 == -1 ? "above" : "aside";
    expect_proportion(
        got.call, "a direction met the light", static_cast<std::uint64_t>(all), n * replicates, p,
        {"directions with density cos / pi meet a light " + where + " with probability E / (pi L)",
         alpha},
        {{{uniform_share,
           "these directions are uniform on the hemisphere: steep ones must be more"}},
         "a uniform point of the unit disk (radius sqrt(u)), lifted to the hemisphere, and two "
         "numbers for each"});
    // The hits of one estimate are independent too: their number has a binomial's variance.
    expect_variance({got.call + ", directions that met the light", met, n}, p * n, p * (1 - p) * n,
                    3 + (1 - 6 * p * (1 - p)) / (p * (1 - p) * n),
                    {"directions are independent, light " + where, alpha},
                    {{}, "n independent directions"});
  }
  expect_invalid_argument(MEASURE_OUTCOME(irradiance_hemisphere, {}, 0, 1, 1), "n",
                          "the mean of nothing is no estimate");
}

TEST_CASE("2.7 both estimates know their error", "[2.7][points:3][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 64, replicates = 2000;
  const double size = n;
  for (const RectLight& light : fresh_lights(rng)) {
    const std::string where = light.x0 == -1 ? "above" : "aside";
    const auto by_area = MEASURE(irradiance_area, light, n, rng(), replicates);
    require_size(by_area.call, by_area.value.size(), replicates);
    // E{s^2} = sigma^2, and Var{s^2} = (kurtosis - (n-3)/(n-1)) sigma^4 / n for independent values.
    const Population x = of_area(light);
    Values squares;
    for (const Estimate& one : by_area.value) {
      squares.push_back(one.standard_error * one.standard_error * size / x.variance);
    }
    expect_mean(
        {by_area.call + ", n standard_error^2 / variance", squares, n}, 1,
        (x.kurtosis - (size - 3) / (size - 1)) / size,
        {"squared standard errors of a light " + where + " have the mean variance / n", alpha},
        {{{size, "s instead of s / sqrt(n)"}, {(size - 1) / size, "n - 1 below s^2"}},
         "s / sqrt(n) of the values of the samples"});

    const auto by_hemisphere = MEASURE(irradiance_hemisphere, light, n, rng(), 100);
    const Values met = directions_met(by_hemisphere.call, by_hemisphere.value, light, n);
    const double each = std::numbers::pi * light.radiance;
    for (std::size_t i = 0; i < met.size(); ++i) {
      const double s2 = each * each * met[i] * (size - met[i]) / (size * (size - 1));
      expect_within(
          by_hemisphere.call + ".standard_error", by_hemisphere.value[i].standard_error,
          std::sqrt(s2 / size), 1e-7 * each,
          fmt::format("{} of {} directions met the light", met[i], size),
          {{{std::sqrt(s2), "s instead of s / sqrt(n)"}, {s2 / size, "this is its square"}},
           "s / sqrt(n) of the values of the samples"});
    }
  }
  const auto area_of_one = MEASURE(irradiance_area, {}, 1, rng(), 1);
  const auto hemisphere_of_one = MEASURE(irradiance_hemisphere, {}, 1, rng(), 1);
  require_size(area_of_one.call, area_of_one.value.size(), 1);
  require_size(hemisphere_of_one.call, hemisphere_of_one.value.size(), 1);
  const std::string because = "one value says nothing about how values vary";
  expect_nan(area_of_one.call + ".standard_error", area_of_one.value[0].standard_error, because);
  expect_nan(hemisphere_of_one.call + ".standard_error", hemisphere_of_one.value[0].standard_error,
             because);
}

// 2.8 ---------------------------------------------------------------------------------------------

void expect_in_unit(const std::string& call, const Values& u) {
  const auto outside =
      std::find_if(u.begin(), u.end(), [](double value) { return !(value >= 0 && value < 1); });
  if (outside == u.end()) return pass();
  expect_that(false, fmt::format("{}: number {} is {}", call, outside - u.begin(), *outside),
              "numbers in [0, 1), all of them", "a span of any size is to be filled",
              *outside == 2 ? "2 is what stood there before: it was not filled. The last, "
                              "shorter block?"
                            : "is something rounded up to 1?");
}

TEST_CASE("2.8 a span of any size is filled with new numbers", "[2.8][points:3][needs:2.1]") {
  Rng rng = check_rng();
  std::vector<std::uint64_t> sizes{0, 1, 2, 3, 7, 31, 64, 65, 127, 128, 129, 1000, 4096, 10007};
  sizes.push_back(rng() % 3000);
  const std::uint64_t seed = rng();
  const auto got = MEASURE(uniforms, seed, sizes), again = MEASURE(uniforms, seed, sizes);
  expect_in_unit(got.call, got.value);
  expect_that(got.value == again.value, got.call + " gave other numbers when it was repeated",
              "the same numbers", "the generator it is given is its only source of randomness",
              "no generator of your own, no clock, nothing static");
  for (const std::uint64_t word : {std::uint64_t{0}, ~std::uint64_t{0}}) {
    const auto corner = MEASURE(uniforms_constant, word, 1000);
    expect_in_unit(corner.call, corner.value);
  }
  // Of N numbers with 53 bits, N^2 / 2^54 pairs are equal by chance: 9e-6 for N = 4e5, so that
  // three are as good as impossible (1e-16). With 32 bits there would be 19.
  const auto many = MEASURE(uniforms, rng(), {200000, 100000, 100000});
  Values sorted = many.value;
  std::sort(sorted.begin(), sorted.end());
  std::uint64_t equal = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) equal += sorted[i] == sorted[i - 1] ? 1 : 0;
  expect_that(equal<3, fmt::format("{}: {} numbers came twice", many.call, equal), "none, or one",
                    "400,000 numbers of 53 bits each are all different", equal> 50000
                  ? "do two calls, or two lanes, begin in the same place?"
                  : "how many bits of each number are random?");
}

TEST_CASE("2.8 the numbers are uniform in all of their bits", "[2.8][points:4][needs:2.1]") {
  Rng rng = check_rng();
  const auto got = MEASURE(uniforms, rng(), {4096, 1, 4096, 100, 63000, 28707});
  require_size(got.call, got.value.size(), 100000);
  expect_in_unit(got.call, got.value);
  const auto n = static_cast<double>(got.value.size());
  expect_distribution(got.call, got.value, [](double u) { return u; },
                      {"numbers of 2.8 are uniform", alpha},
                      {{}, "each is to_unit() of 53 bits that were not used before"});
  // Bit b of floor(2^53 u) is a fair coin, and so is the exclusive or of two different bits.
  Values ones(53), differing(52);
  for (const double u : got.value) {
    const auto bits = static_cast<std::uint64_t>(u * 0x1p53);
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
  expect_variance({got.call + ", z of each of 53 bits", ones, 1}, 0, 1, 3,
                  {"each bit of a number is a fair coin", alpha},
                  {{}, "53 random bits, also in the last places: which are always 0, or 1?"});
  expect_variance({got.call + ", z of bits that differ from those 1 to 52 places on", differing, 1},
                  0, 1, 3, {"the bits of a number are independent", alpha},
                  {{}, "no bit of a word is used twice in a number"});
}

TEST_CASE("2.8 the numbers know nothing of each other", "[2.8][points:4][needs:2.1]") {
  Rng rng = check_rng();
  const std::size_t half = 50000;
  const auto got = MEASURE(uniforms, rng(), {half, half});
  require_size(got.call, got.value.size(), 2 * half);
  expect_in_unit(got.call, got.value);
  const Values& u = got.value;
  // Three in a row: lanes that run in step are independent two by two.
  std::vector<std::uint64_t> triples(216);
  for (std::size_t i = 0; i + 2 < u.size(); i += 3) {
    const auto cell = [&](std::size_t k) { return static_cast<std::size_t>(6 * u[i + k]); };
    ++triples[36 * cell(0) + 6 * cell(1) + cell(2)];
  }
  expect_counts(got.call + ", three in a row, in 6 x 6 x 6 cells", triples,
                std::vector<double>{1.0 / 216}, {"three numbers in a row are independent", alpha},
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
  expect_variance({got.call + ", z of correlations 1 to 64 places on, and from call to call", z, 1},
                  0, 1, 3, {"numbers at any distance are uncorrelated", alpha},
                  {{}, "do lanes, or calls, run along the same sequence?"});
}

}  // namespace
}  // namespace mc::checks
