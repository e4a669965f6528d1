// Task 2.5: confidence intervals, and how often they hold the truth.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "checks/independent/traces.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/statistics.hpp"
#include "common/normal_quantile.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("2.5 a confidence interval of a given level", "[2.5][points:4][main]") {
  Rng rng = check_rng();
  for (const double level :
       {uniform(rng, 0.55, 0.93), uniform(rng, 0.01, 0.5), 0.95, 0.6827, 0.5, 0.99, 0.999999}) {
    const Estimate estimate{uniform(rng, -9, 9), uniform(rng, 0.01, 1), 10 + rng() % 1000};
    const auto got = MEASURE(confidence_interval, estimate, level);
    const double z = normal_quantile((1 + level) / 2), reach = z * estimate.standard_error;
    const double one_sided = normal_quantile(level) * estimate.standard_error;
    const double value = estimate.value, root = std::sqrt(static_cast<double>(estimate.n));
    // (1 - level) / 2 may be formed with one rounding of the level, 1e-16 of 5e-7: nine digits.
    const auto end = [&](const std::string& name, double got_end, double sign) {
      expect_within(
          got.call + "." + name, got_end, value + sign * reach,
          1e-9 * reach + 4 * eps * std::abs(value),
          fmt::format("{:.7g} standard errors to either side leave {:.3g} outside, half of it on "
                      "either side",
                      z, 1 - level),
          {{{value + sign * one_sided,
             "what the interval leaves out lies on both sides: take the quantile of (1 + level) / "
             "2"},
            {value - sign * one_sided,
             "what the interval leaves out lies on both sides: take the quantile of (1 + level) / "
             "2"},
            {value + sign * estimate.standard_error, "one standard error covers 68 %, always"},
            {value + sign * 1.96 * estimate.standard_error, "1.96 is for 95 % alone"},
            {value + sign * 2 * estimate.standard_error, "2 is for 95.45 % alone"},
            {value + sign * reach / root, "standard_error belongs to the mean: it knows n already"},
            {value + sign * reach * root, "standard_error is that of the mean, not of one value"},
            {value - sign * reach, "low and high are the wrong way round"},
            {sign * reach, "the interval stands around the value, not around 0"}},
           "value ± normal_quantile((1 + level) / 2) standard errors"});
    };
    end("low", got.value.low, -1);
    end("high", got.value.high, 1);
  }
}

CHECK_CASE("2.5 levels outside 0 to 1 are refused", "[2.5][points:1][edge]") {
  for (const double level : {1.5, -0.5, 1.0, 0.0, nan}) {
    expect_invalid_argument(MEASURE_OUTCOME(confidence_interval, {1, 0.1, 100}, level), "",
                            "a level is a probability, and neither 0 nor 1");
  }
}

/// How many intervals hold the true mean.
std::uint64_t covering(const std::vector<Interval>& intervals, double truth) {
  std::uint64_t count = 0;
  for (const Interval& one : intervals) count += one.low <= truth && truth <= one.high ? 1 : 0;
  return count;
}

/// Each interval is that of the n values behind it: nine digits of it, and where it is short and
/// near 0, what is left of values of size 1.
void expect_intervals_of(const std::string& call, const experiments::IntervalTraces& seen,
                         std::size_t n, double z) {
  for (std::size_t i = 0; i < seen.intervals.size(); ++i) {
    const auto moments = exact_moments(std::span(seen.values).subspan(i * n, n));
    const double mean = static_cast<double>(moments.mean);
    const double reach = z * std::sqrt(moments.variance / static_cast<double>(n));
    const Interval& got = seen.intervals[i];
    const double tolerance = 1e-9 * (reach + std::abs(mean)) + 1e-12;
    if (std::abs(got.low - (mean - reach)) <= tolerance &&
        std::abs(got.high - (mean + reach)) <= tolerance) {
      continue;
    }
    expect_that(
        false, fmt::format("{}: interval {} is {} to {}", call, i, got.low, got.high),
        fmt::format("{} to {}, from the {} values of its estimate", mean - reach, mean + reach, n),
        "an interval comes from the values of one estimate",
        "value ± normal_quantile((1 + level) / 2) standard errors");
  }
}

CHECK_CASE("2.5 intervals of normal samples cover as often as theory says",
           "[2.5][points:3][needs:2.1][needs:2.2]") {
  Rng rng = check_rng();
  const std::uint64_t replicates = 4000;
  const std::string sizes[] = {"a few", "some", "many"};
  const std::uint64_t ns[] = {4 + rng() % 4, 15 + rng() % 10, 80 + rng() % 20};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint64_t n = ns[i];
    const double level = uniform(rng, 0.75, 0.95);
    const Function g = fresh(normal, rng);
    const auto measured = MEASURE(interval_traces, g, n, level, rng(), replicates);
    const auto& seen = measured.exactly({replicates, replicates * n});
    // (mean - truth) / (s / sqrt(n)) of n normal values is Student's t; its square is F(1, n-1).
    const double z = normal_quantile((1 + level) / 2);
    const double exact = f_tails(z * z, 1, static_cast<double>(n - 1)).lower;
    expect_proportion(
        measured.call, "the interval contained the true mean", covering(seen.intervals, g.offset),
        replicates, exact,
        {"intervals from " + sizes[i] + " normal samples cover as Student's t says", alpha},
        {{{0, "the intervals never contain the mean: are they around the estimate?"}},
         fmt::format("level {:.4g} and {} samples cover with probability {:.4f}; is "
                     "the quantile that of (1 + level) / 2?",
                     level, n, exact)});
    expect_intervals_of(measured.call, seen, n, z);
    expect_distribution(
        measured.call + ", values of g", seen.values,
        [&](double value) { return normal_tails((value - g.offset) / g.scale).lower; },
        {"the values behind intervals from " + sizes[i] + " samples are normal", alpha},
        {{}, "see 2.2: are the points uniform?"});
  }
}

CHECK_CASE("2.5 intervals of rare events cover as rarely as theory says",
           "[2.5][points:3][needs:2.1][needs:2.2]") {
  Rng rng = check_rng();
  const std::uint64_t replicates = 4000;
  for (const double p : {uniform(rng, 0.01, 0.03), uniform(rng, 0.08, 0.2)}) {
    const std::string events = p < 0.05 ? "rare events" : "not so rare events";
    const std::uint64_t n = 50 + rng() % 30;
    const double level = uniform(rng, 0.9, 0.97);
    const Function g = fresh(step, rng, p);
    const auto measured = MEASURE(interval_traces, g, n, level, rng(), replicates);
    const auto& seen = measured.exactly({replicates, replicates * n});
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
        measured.call, "the interval contained the true mean",
        covering(seen.intervals, g.scale * p + g.offset), replicates, exact,
        {"intervals of " + events + " cover as rarely as they must", alpha},
        {{},
         "an honest standard error of a rare event is often 0: nothing happened, nothing varies"});
    expect_intervals_of(measured.call, seen, n, z);
    const auto happened = std::count(seen.values.begin(), seen.values.end(), g.scale + g.offset);
    expect_proportion(measured.call, fmt::format("x < {:.3g}", p),
                      static_cast<std::uint64_t>(happened), n * replicates, p,
                      {events + " behind intervals happen as often as they should", alpha},
                      {{}, "see 2.2: are the points uniform?"});
  }
}

}  // namespace
}  // namespace mc::checks
