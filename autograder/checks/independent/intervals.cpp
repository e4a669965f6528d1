// Task 2.5: confidence intervals, and how often they hold the truth.

#include <algorithm>
#include <cmath>

#include "checks/independent/functions.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/domain.hpp"
#include "checks/support/exact.hpp"
#include "checks/support/refusals.hpp"
#include "checks/support/statistics.hpp"
#include "common/normal_quantile.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("2.5 a confidence interval of a given level", "[2.5][points:4][main]") {
  Rng rng = check_rng();
  Results ends;
  std::vector<double> levels{0.95, 0.6827, 0.5, 0.99, 0.999999, 1e-6};
  for (int i = 0; i < 10; ++i) levels.insert(levels.begin(), uniform(rng, 0.01, 0.93));
  for (const double level : levels) {
    const double scale = std::pow(10, uniform(rng, -3, 3));
    const double spread = level == 0.95 ? 0 : uniform(rng, 0.01, 1);  // no spread, no interval
    const Estimate estimate{uniform(rng, -9, 9) * scale, spread * scale, 10 + rng() % 1000};
    const auto got = MEASURE(confidence_interval, estimate, level);
    const double z = normal_quantile((1 + level) / 2), error = estimate.standard_error;
    const double reach = z * error, one_sided = normal_quantile(level) * error;
    const double value = estimate.value, root = std::sqrt(static_cast<double>(estimate.n));
    for (const double sign : {-1.0, 1.0}) {
      // (1 - level) / 2 may be formed with one rounding of the level, 1e-16 of 5e-7: nine digits.
      // A level near 0 has a quantile near 0, which normal_quantile() knows to 1e-16.
      ends.add(got.call + (sign < 0 ? ".low" : ".high"), sign < 0 ? got.value.low : got.value.high,
               value + sign * reach, 1e-9 * reach + 4 * eps * (std::abs(value) + error),
               [=]() -> std::vector<Suspect> {
                 const std::string both =
                     "what the interval leaves out lies on both sides: take the quantile of "
                     "(1 + level) / 2";
                 return {{value + sign * one_sided, both},
                         {value - sign * one_sided, both},
                         {value + sign * error, "one standard error covers 68 %, always"},
                         {value + sign * 1.96 * error, "1.96 is for 95 % alone"},
                         {value + sign * 2 * error, "2 is for 95.45 % alone"},
                         {value + sign * normal_quantile(0.975) * error, "1.96 is for 95 % alone"},
                         {value + sign * reach / root,
                          "standard_error belongs to the mean: it knows n already"},
                         {value + sign * reach * root,
                          "standard_error is that of the mean, not of one value"},
                         {value - sign * reach, "low and high are the wrong way round"},
                         {sign * reach, "the interval is around the value, not around 0"}};
               });
    }
  }
  ends.expect("the normal quantile leaves half of 1 - level outside on either side",
              "value ± normal_quantile((1 + level) / 2) standard errors");
}

CHECK_CASE("2.5 levels outside 0 to 1 are refused", "[2.5][points:1][edge]") {
  std::vector<InvalidCall> calls;
  for (const double level : {1.5, -0.5, 1.0, 0.0, nan, domain::infinity, -domain::infinity}) {
    calls.push_back({MEASURE_OUTCOME(confidence_interval, {1, 0.1, 100}, level), "level",
                     "a level is a probability, and neither 0 nor 1"});
  }
  expect_refused(calls);
}

/// A case of which theory says how often intervals hold the true mean.
struct Coverage {
  std::string words;
  Function g;
  std::uint64_t n;
  double level, truth, exact;
};

/// Of n normal values (mean - truth) / (s / sqrt(n)) is Student's t; its square is F(1, n-1).
Coverage of_normal(Rng& rng, const std::string& words, std::uint64_t n) {
  const Function g = fresh(normal, rng);
  const double level = uniform(rng, 0.75, 0.95), z = normal_quantile((1 + level) / 2);
  return {words + " normal samples",
          g,
          n,
          level,
          g.offset,
          f_tails(z * z, 1, static_cast<double>(n - 1)).lower};
}

/// Of n trials k succeed; s^2 = k (n - k) / (n (n - 1)). No success, no spread, no interval.
Coverage of_events(Rng& rng, const std::string& words, double p) {
  const std::uint64_t n = 50 + rng() % 30;
  const double level = uniform(rng, 0.9, 0.97), z = normal_quantile((1 + level) / 2);
  const auto size = static_cast<double>(n);
  double exact = 0;
  for (std::uint64_t k = 0; k <= n; ++k) {
    const auto successes = static_cast<double>(k);
    const double reach = z * std::sqrt(successes * (size - successes) / (size - 1)) / size;
    if (std::abs(successes / size - p) > reach) continue;
    const Tails here = binomial_tails(k, n, p);
    exact += here.lower + here.upper - 1;
  }
  const Function g = fresh(step, rng, p);
  return {words, g, n, level, g.scale * p + g.offset, exact};
}

CHECK_CASE("2.5 intervals cover as often as theory says", "[2.5][points:6][needs:2.1][needs:2.2]") {
  Rng rng = check_rng();
  const std::uint64_t replicates = 4000;
  for (const auto& [words, g, n, level, truth, exact] :
       {of_normal(rng, "a few", 4 + rng() % 4), of_normal(rng, "some", 15 + rng() % 10),
        of_normal(rng, "many", 80 + rng() % 20), of_events(rng, "rare events", 0.02),
        of_events(rng, "not so rare events", uniform(rng, 0.08, 0.2))}) {
    const auto got = MEASURE(interval_traces, g, n, level, rng(), replicates);
    const auto& seen = got.list_by_list({{replicates, any_number}, {replicates * n, finite}});
    const double z = normal_quantile((1 + level) / 2);
    std::uint64_t covering = 0;
    Results ends;
    for (std::size_t i = 0; i < replicates; ++i) {
      const Interval& one = seen.intervals[i];
      covering += one.low <= truth && truth <= one.high ? 1 : 0;
      // Each interval is that of the values behind it: nine digits of it, and where it is short and
      // near 0, what is left of values of size 1.
      const auto moments = exact_moments(std::span(seen.values).subspan(i * n, n));
      const auto mean = static_cast<double>(moments.mean);
      const double reach = z * std::sqrt(moments.variance / static_cast<double>(n));
      const double tolerance = 1e-9 * (reach + std::abs(mean)) + 1e-12;
      const std::string name = fmt::format("{}: interval {}", got.call, i);
      ends.add(name + ".low", one.low, mean - reach, tolerance);
      ends.add(name + ".high", one.high, mean + reach, tolerance);
    }
    expect_proportion(
        got.call, "the interval contained the true mean", covering, replicates, exact,
        {"intervals of " + words + " cover as often as theory says", alpha},
        {{{0, "the intervals never contain the mean: are they around the estimate?"}},
         fmt::format("level {:.4g} and {} samples cover with probability {:.4f}; is the quantile "
                     "that of (1 + level) / 2? An honest standard error of a rare event is often 0",
                     level, n, exact)});
    ends.expect("an interval comes from the values of one estimate",
                "value ± normal_quantile((1 + level) / 2) standard errors");
  }
}

}  // namespace
}  // namespace mc::checks
