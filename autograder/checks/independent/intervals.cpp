// 2.5, 2.6: confidence intervals and their coverage; the number of samples for a target error.

#include "checks/independent/functions.hpp"
#include "common/normal_quantile.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("2.5 a confidence interval of a given level", "[2.5][points:6][main]") {
  Results ends;
  std::vector<double> levels{0.95, 0.6827, 0.5, 0.99, 0.999999, 1e-6};
  for (int i = 0; i < 10; ++i) levels.insert(levels.begin(), uniform(rng, 0.01, 0.93));
  for (const double level : levels) {
    const double scale = std::pow(10, uniform(rng, -3, 3));
    const double spread =
        level == levels[0] ? 0 : uniform(rng, 0.01, 1);  // an interval of length 0
    const Estimate estimate{uniform(rng, -9, 9) * scale, spread * scale, 10 + rng() % 1000};
    const auto got = MEASURE(confidence_interval, estimate, level);
    const double z = normal_quantile((1 + level) / 2), error = estimate.standard_error;
    const double reach = z * error;
    const double value = estimate.value;
    for (const double sign : {-1.0, 1.0}) {
      // (1 - level) / 2 may have a rounding error of 1e-16 in 5e-7: nine digits are left. A level
      // near 0 has a quantile near 0, which normal_quantile() returns with an error of 1e-16.
      ends.add(
          got.call + (sign < 0 ? ".low" : ".high"), sign < 0 ? got.value.low : got.value.high,
          value + sign * reach, 1e-9 * reach + 4 * eps * (std::abs(value) + error),
          [=]() -> std::vector<Suspect> {
            return {{value + sign * normal_quantile(level) * error,
                     "the interval excludes two tails: use (1 + level) / 2"_likely},
                    {value + sign * 1.96 * error, "1.96 is for a level of 95 % only"_likely},
                    {value + sign * reach / std::sqrt(static_cast<double>(estimate.n)),
                     "standard_error is that of the mean: it is already divided by sqrt(n)"_likely},
                    {value, "the interval has length 0"_likely},
                    {value + sign * reach / 2,
                     "the interval has half of its length: z standard errors to each side"_likely},
                    {value - sign * reach, "low and high are swapped"_likely}};
          });
    }
  }
  ends.expect("the interval leaves (1 - level) / 2 outside on each side",
              "value ± normal_quantile((1 + level) / 2) standard errors");
}

/// A case with a known probability, `exact`, that an interval contains the true mean.
struct Coverage {
  std::string words;
  Function g;
  std::uint64_t n;
  double level, truth, exact;
};

Coverage of_normal(Rng& rng, const std::string& words, std::uint64_t n);
Coverage of_events(Rng& rng, const std::string& words, double p);

CHECK_CASE("2.5 intervals cover as often as theory says", "[2.5][points:8][needs:2.1][needs:2.2]") {
  const std::uint64_t replicates = 4000;
  for (const auto& [words, g, n, level, truth, exact] :
       {of_normal(rng, "a few", 4 + rng() % 4), of_normal(rng, "some", 15 + rng() % 10),
        of_normal(rng, "many", 80 + rng() % 20), of_events(rng, "rare events", 0.02),
        of_events(rng, "less rare events", uniform(rng, 0.08, 0.2))}) {
    const auto got = MEASURE(interval_traces, g, n, level, rng(), replicates);
    const auto& seen = got.list_by_list({{replicates, any_number}, {replicates * n, finite}});
    const double z = normal_quantile((1 + level) / 2);
    std::uint64_t covering = 0;
    Results ends;
    for (std::size_t i = 0; i < replicates; ++i) {
      const Interval& one = seen.intervals[i];
      covering += one.low <= truth && truth <= one.high ? 1 : 0;
      // Each interval follows from its values, to nine digits or the rounding error of values of
      // size 1.
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
        {{},
         "take the quantile of (1 + level) / 2, and keep a standard error of 0 if a rare event "
         "never happens"});
    ends.expect("an interval follows from the values of one estimate",
                "value ± normal_quantile((1 + level) / 2) standard errors");
  }
}

struct Plan {
  Estimate pilot;
  double target;
};

void judge_plans(const std::vector<Plan>& plans);

CHECK_CASE("2.6 the samples that bring the error down", "[2.6][points:2][main]") {
  std::vector<Plan> plans;
  for (int i = 0; i < 10; ++i) {
    const Estimate pilot{uniform(rng, -9, 9), uniform(rng, 0.01, 1), 1000 + rng() % 100000};
    plans.push_back({pilot, pilot.standard_error / uniform(rng, 2, 5)});
  }
  // (3/2)^2 n, n = 4k + 1: an integer plus 1/4, which rounding to nearest rounds down.
  const double target = uniform(rng, 0.01, 1);
  plans.push_back({{uniform(rng, -9, 9), 1.5 * target, 4 * (250 + rng() % 10000) + 1}, target});
  plans.push_back({{1, 0.25, 1000}, 0.125});  // 4000 exactly
  judge_plans(plans);
  plans = {{{1, 0.1, 1000}, 0.7},  // fewer than the pilot had
           {{1, 0.5, 5}, 1},       // 1.25, so two
           {{1, 0.5, 1}, 0.25},    // the smallest pilot
           {{1, 0.5, 4}, 1},       // one
           {{1, 0.5, 2}, 0.5},     // equal errors: as many as the pilot had
           {{1, 0.5, 3}, 0.5},    {{1, 0.5, 1000000}, 1e-4}};  // 2.5e13
  for (int i = 0; i < 5; ++i) {
    plans.push_back({{1, uniform(rng, 0.5, 50), rng() >> 24}, uniform(rng, 0.5, 1)});
  }
  judge_plans(plans);
}

CHECK_CASE("2.6 at least one sample and at most 64 bits at any scale", "[2.6][points:1][edge]") {
  judge_plans({{{1, 1, 1000}, 1e-8},                   // 1e19 fits into an unsigned 64-bit integer
               {{-5, 3e170, 17}, 1e169},               // the separate squares overflow
               {{-5, 3e-170, 17}, 1e-170},             // or underflow to 0
               {{1, 0.5, std::uint64_t{1} << 62}, 1},  // a huge pilot
               {{1, 0.5, std::uint64_t{3} << 62}, 0.75},
               {{1, 0.5, ~std::uint64_t{0}}, 1}});  // the largest pilot
  for (const auto& [error, target] : {std::pair{1e-9, 1.0}, {0.0, 0.1}, {1.0, infinity}}) {
    const auto got = MEASURE(samples_for, {1, error, 100}, target);
    expect_that(got.value == 1, fmt::format("{} = {}", got.call, got.value), "1",
                "the target is met already, but an estimate needs a sample", "return at least 1");
  }
}

// What the cases above use ------------------------------------------------------------------------

/// For n normal values, ((mean - truth) / (s / sqrt(n)))^2 has the distribution F(1, n-1).
Coverage of_normal(Rng& rng, const std::string& words, std::uint64_t n) {
  const Function g = fresh(normal, rng);
  const double level = uniform(rng, 0.75, 0.95), z = normal_quantile((1 + level) / 2);
  const double exact = f_tails(z * z, 1, static_cast<double>(n - 1)).lower;
  return {words + " normal samples", g, n, level, g.offset, exact};
}

/// If k of n trials succeed, s^2 = k (n - k) / (n (n - 1)).
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

void judge_plans(const std::vector<Plan>& plans) {
  Results samples;
  for (const auto& [pilot, target] : plans) {
    const auto got = MEASURE(samples_for, pilot, target);
    const Exact ratio = Exact(pilot.standard_error) / Exact(target);
    const double n = static_cast<double>(pilot.n), plain = static_cast<double>(ratio);
    const double exact = static_cast<double>(ratio * ratio * Exact(n)), slack = 8 * eps * exact;
    // The quotient may have 8 rounding errors. One sample too many is accepted, one too few is not.
    const bool is_huge = slack > 0.01;
    const double fewest = is_huge ? exact : std::max(1.0, std::ceil(exact - slack));
    const auto value = static_cast<double>(got.value);
    const bool is_one_more = value == fewest + 1;
    samples.add(got.call, is_one_more ? fewest : value, fewest, slack + is_huge,
                [=]() -> std::vector<Suspect> {
                  const Likely up = "this is slightly too few: round up"_likely;
                  return {
                      {std::floor(exact), up},
                      {std::round(exact), up},
                      {std::ceil(n * plain),
                       "half the error costs four times the samples: square the ratio"_likely},
                      {std::ceil(exact) - n,
                       "the task asks for the total number, not for additional samples"_likely}};
                });
  }
  samples.expect("the error falls as 1 / sqrt(n)", "n (standard error / target)^2, rounded up");
}

}  // namespace
}  // namespace mc::checks
