// Task 2.2 against exact means and variances: with fresh integrands scale · g + offset and fresh
// seeds in every run.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "checks/independent/traces.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {
namespace {

/// Where pairs (x, y) of numbers in [0, 1) fall, in 16 x 16 cells: of the first and second number,
/// then of those `stride` on …
std::vector<std::uint64_t> pair_counts(const Values& x, std::size_t first, std::size_t second,
                                       std::size_t stride) {
  std::vector<std::uint64_t> counts(256);
  for (std::size_t i = 0; std::max(first, second) + i < x.size(); i += stride) {
    const auto cell = [&](std::size_t k) { return static_cast<std::size_t>(16 * x[k + i]); };
    ++counts[16 * cell(second) + cell(first)];
  }
  return counts;
}

const Values even_cells{1.0 / 256};

CHECK_CASE("2.2 the points are uniform and independent", "[2.2][points:2][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 60000;
  const Traced seen(fresh(product, rng), n, rng);
  const Values& u = seen.points();
  std::size_t diagonal = 0;
  for (std::size_t i = 0; i < u.size(); i += 2) diagonal += u[i] == u[i + 1] ? 1 : 0;
  expect_that(diagonal < u.size() / 4,
              fmt::format("{}: x = y in {} of {} points", seen.call(), diagonal, u.size() / 2),
              "x and y that are independent", "",
              "draw a number for each dimension: one number for both fills a line");
  // Of 120,000 numbers with 32 bits 1.7 came before, on average, and 34 never (1e-29); with the 24
  // bits of a float 429 do, and never less than 200 (1e-28).
  expect_distinct(seen.call(), "coordinates", u, 33,
                  "each coordinate is to_unit() of a word of its own, with all of its 53 bits");
  expect_distribution(seen.call() + ", coordinates", u, [](double at) { return at; },
                      {"coordinates are uniform and independent", alpha},
                      {{}, "every coordinate is to_unit() of a word of its own"});
  expect_counts(seen.call() + ", points", pair_counts(u, 0, 1, 2), even_cells,
                {"the two coordinates of a point are independent", alpha},
                {{}, "draw a number for each dimension"});
  expect_counts(seen.call() + ", neighbours", pair_counts(u, 1, 2, 2), even_cells,
                {"the x of a point is independent of the y before it", alpha},
                {{}, "no number is used twice"});
  expect_counts(seen.call() + ", pairs of points, x and x", pair_counts(u, 0, 2, 4), even_cells,
                {"the x of a point is independent of the x before it", alpha},
                {{}, "each point is drawn afresh: neither a copy nor a mirror image of another"});
}

/// The values of estimates that are the means of what they saw.
Values means_of(const Traced& seen) {
  Values values = values_of(seen.estimates());
  require_finite(seen.call(), values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    expect_mean_of(fmt::format("{}, estimate {}", seen.call(), i), values[i], seen.values_of(i));
  }
  return values;
}

CHECK_CASE("2.2 the estimate is unbiased with variance sigma^2 over n",
           "[2.2][points:3][needs:2.1]") {
  Rng rng = check_rng();
  const std::uint64_t n = 64, replicates = 400;
  const double p = uniform(rng, 0.2, 0.8);
  const std::pair<Function, Population> cases[] = {{fresh(exponential, rng), of_exponential()},
                                                   {fresh(product, rng), of_product()},
                                                   {fresh(step, rng, p), of_step(p)}};
  for (const auto& [g, x] : cases) {
    const Traced seen(g, n, rng, replicates);
    const Values values = means_of(seen);
    if (g.g != step) expect_new_numbers(seen.call(), values);
    const Population truth = transformed(x, g);
    const Known known = mean_of(truth, n);
    const std::string name = g.g == exponential ? "exp(x)" : g.g == product ? "x y" : "a step";
    expect_mean({seen.call(), values, n}, known.exact, known.variance,
                {"estimates of " + name + " have the mean E{g}", alpha},
                {{{g.g == product ? g.scale / 3 + g.offset : nan,
                   "that is the mean of x^2: one number for both x and y"}},
                 "the mean of g at uniform points, nothing else"});
    expect_variance({seen.call(), values, n}, known.exact, known.variance, known.kurtosis,
                    {"estimates of " + name + " have the variance Var{g} / n", alpha},
                    {{{n, "each estimate is as bad as a single sample: are its points different?"}},
                     "n independent points, and estimates that have nothing in common"});
  }
}

CHECK_CASE("2.2 the error falls as one over root n", "[2.2][points:2][needs:2.1]") {
  Rng rng = check_rng();
  const Function g = fresh(exponential, rng);
  const std::uint64_t few = 16, many = 1024, replicates = 200;
  const Traced at_few(g, few, rng, replicates), at_many(g, many, rng, replicates);
  const Population truth = transformed(of_exponential(), g);
  const Values few_values = means_of(at_few), many_values = means_of(at_many);
  expect_new_numbers(at_few.call(), few_values);
  expect_rate({at_few.call(), few_values, few}, mean_of(truth, few),
              {at_many.call(), many_values, many}, mean_of(truth, many),
              {"the error of independent samples falls as N^-1/2", alpha},
              {{{0, "more samples change nothing: are they the same ones again?"},
                {1, "faster than independent samples can: these are not"}},
               "n independent samples, every one of them new"});
}

/// Estimates that took n evaluations each, and are numbers.
Values estimates_of(const Measured<std::vector<experiments::Counted>>& measured, std::uint64_t n,
                    std::uint64_t replicates) {
  const auto& estimates = measured.exactly(replicates, any_number);
  for (const auto& one : estimates) {
    expect_that(one.evaluations == n,
                fmt::format("{}: one of them evaluated g {} times", measured.call, one.evaluations),
                fmt::format("{}", n), "n is what the caller pays for",
                "every sample is one evaluation");
  }
  Values values = values_of(estimates);
  require_finite(measured.call, values);
  return values;
}

CHECK_CASE("2.2 rare events and a narrow peak", "[2.2][points:1][needs:2.1]") {
  Rng rng = check_rng();
  // An event of probability p: n times the estimate is how often it happened.
  for (const auto& [p, n] : {std::pair<double, std::uint64_t>{uniform(rng, 0.5e-4, 2e-4), 10000},
                             {uniform(rng, 2e-6, 4e-6), 20000}}) {
    const std::uint64_t replicates = 100;
    const Function g = fresh(step, rng, p);
    const auto measured = MEASURE(estimates, g, n, rng(), replicates);
    double happened = 0;
    for (const double value : estimates_of(measured, n, replicates)) {
      const double times = (value - g.offset) / g.scale * static_cast<double>(n);
      expect_within(measured.call + ": (value - offset) n / scale", times, std::round(times), 1e-6,
                    "an event happens a whole number of times",
                    {{}, "the mean of n values that are 0 or 1"});
      expect_that(times > -0.5 && times < static_cast<double>(n) + 0.5,
                  fmt::format("{}: {} events", measured.call, times),
                  fmt::format("0 to {} of them", n), "", "the mean of n values that are 0 or 1");
      happened += std::round(times);
    }
    expect_proportion(measured.call, fmt::format("x < {:.3g}", p),
                      static_cast<std::uint64_t>(happened), n * replicates, p,
                      {p > 1e-5 ? "events of probability 1e-4 happen as often as they should"
                                : "events of probability 1e-6 happen as often as they should",
                       alpha},
                      {{}, "how many different numbers can to_unit() make near 0?"});
  }
  // A peak of width s: E{g^k} = 2 pi s^2 / k, but for what the edges cut off.
  const double s = uniform(rng, 0.02, 0.04);
  const auto moment = [&](double k) {
    const double width = s / std::sqrt(k);
    const auto share = [&](double centre) {
      return 1 - normal_tails(-centre / width).lower - normal_tails((1 - centre) / width).upper;
    };
    return 2 * std::numbers::pi * width * width * share(0.3) * share(0.7);
  };
  // The mean of 10^6 values is nearly Gaussian: its skewness is (2/3) / (sqrt(pi) s) / 10^3 < 0.02.
  const std::uint64_t n = 5000, replicates = 200;
  const Function g = fresh(peak, rng, s);
  const auto measured = MEASURE(estimates, g, n, rng(), replicates);
  const Values values = estimates_of(measured, n, replicates);
  expect_new_numbers(measured.call, values);
  const Known known =
      mean_of(transformed(population(moment(1), moment(2), moment(3), moment(4)), g), n);
  expect_mean({measured.call, values, n}, known.exact, known.variance,
              {"estimates of a narrow peak have the mean E{g}", alpha},
              {{}, "uniform points, in x and in y"});
}

}  // namespace
}  // namespace mc::checks
