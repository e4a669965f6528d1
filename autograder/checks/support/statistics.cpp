#include "checks/support/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "checks/support/data.hpp"
#include "checks/support/distributions.hpp"

namespace mc::checks {
namespace {

/// One outcome of a test, ready to be judged and reported.
struct Outcome {
  double measured = 0;                 ///< the statistic, in the unit of the story
  double expected = 0;                 ///< its value under the null
  std::function<Interval()> accepted;  ///< of the statistic; only a failure needs it
  double p = 0;                        ///< two-sided
  double recorded = 0;                 ///< uniform under the null
  std::string measured_words;          ///< with n and replicates
  std::string name;                    ///< of the statistic: "their mean"
};

std::string hint_for(const Outcome& outcome, const Interval& accepted, const Hints& hints) {
  const Suspect* found = nullptr;
  for (const Suspect& suspect : hints.suspects) {
    // As far from the suspect as a right value may be from the expected one: in parts of it where
    // the interval is one of ratios, that is, lies on one side of zero.
    const bool ratio = accepted.low > 0 && suspect.value > 0;
    const double at = ratio ? outcome.measured * outcome.expected / suspect.value
                            : outcome.measured - suspect.value + outcome.expected;
    if (!(accepted.low <= at && at <= accepted.high)) continue;
    if (found != nullptr && found->hint != suspect.hint) return hints.otherwise;  // which of them?
    found = &suspect;
  }
  return found == nullptr ? hints.otherwise : found->hint;
}

/// Records the p-value and returns it; ends the check where it is below alpha.
double judge(const Outcome& outcome, const Null& null, const Hints& hints) {
  record(protocol::RecordKind::p_value,
         protocol::text_of({null.words, outcome.recorded, null.alpha}));
  if (!(outcome.p >= null.alpha)) {
    const Interval accepted = outcome.accepted();
    expect_that(false, outcome.measured_words,
                fmt::format("{} between {:.6g} and {:.6g}; {:.6g} on average", outcome.name,
                            accepted.low, accepted.high, outcome.expected),
                fmt::format("{}: a right answer lies outside once in {:.1g} runs", null.words,
                            1 / null.alpha),
                hint_for(outcome, accepted, hints));
  }
  pass();
  return outcome.recorded;
}

std::string describe(const Replicates& estimates) {
  return estimates.n > 1 ? fmt::format("{}: {} replicates of {} samples each", estimates.call,
                                       estimates.values.size(), estimates.n)
                         : fmt::format("{}: {} values", estimates.call, estimates.values.size());
}

/// Ends the check where a replicate is no number at all.
void require_numbers(const Replicates& estimates, const Hints& hints) {
  const auto odd = std::find_if(estimates.values.begin(), estimates.values.end(),
                                [](double value) { return !std::isfinite(value); });
  if (odd == estimates.values.end() && !estimates.values.empty()) return;
  expect_that(false,
              odd == estimates.values.end() ? estimates.call + ": no values"
                                            : fmt::format("{}: replicate {} is {}", estimates.call,
                                                          odd - estimates.values.begin(), *odd),
              "finite numbers", "", hints.otherwise);
}

double sum_of_squares(const Replicates& estimates, double exact) {
  double sum = 0;
  for (const double value : estimates.values) sum += (value - exact) * (value - exact);
  return sum;
}

double degrees_of(const Replicates& estimates, double kurtosis) {
  return 2 * static_cast<double>(estimates.values.size()) / (kurtosis - 1);
}

/// The least and the largest proportion of successes that an exact binomial test accepts: as
/// central_interval(), on whole numbers.
Interval accepted_proportions(std::uint64_t trials, double p, double alpha) {
  const auto first = [&](auto holds) {  // the first count for which it holds, if any
    std::uint64_t low = 0, high = trials + 1;
    while (low < high) {
      const std::uint64_t middle = low + (high - low) / 2;
      if (holds(binomial_tails(middle, trials, p))) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return static_cast<double>(low);
  };
  const auto size = static_cast<double>(trials);
  return {first([&](const Tails& at) { return at.lower >= alpha / 2; }) / size,
          (first([&](const Tails& at) { return at.upper < alpha / 2; }) - 1) / size};
}

/// For spreading the p-values of discrete statistics: the same in each repetition of a check.
double fresh_uniform() {
  static std::uint64_t calls = 0;
  Rng rng(check_rng()() ^ mix_bits(++calls));
  return uniform(rng);
}

}  // namespace

double expect_mean(const Replicates& estimates, double exact, double variance, const Null& null,
                   const Hints& hints) {
  require_numbers(estimates, hints);
  const auto replicates = static_cast<double>(estimates.values.size());
  double mean = 0;  // of the errors: the sum of many values near 1e9 would be rounded
  for (const double value : estimates.values) mean += (value - exact) / replicates;
  const double sigma = std::sqrt(variance / replicates);
  Outcome outcome;
  outcome.measured = exact + mean;
  outcome.expected = exact;
  outcome.accepted = [&] {
    const Interval z = central_interval(normal_tails, null.alpha, -40, 40);
    return Interval{exact + sigma * z.low, exact + sigma * z.high};
  };
  outcome.p = outcome.recorded = normal_tails(mean / sigma).two_sided();
  outcome.measured_words =
      fmt::format("{}, with the mean {:.8g}, {:.1f} standard errors from {:.8g}",
                  describe(estimates), outcome.measured, mean / sigma, exact);
  outcome.name = "a mean";
  return judge(outcome, null, hints);
}

double expect_variance(const Replicates& estimates, double exact, double variance, double kurtosis,
                       const Null& null, const Hints& hints) {
  require_numbers(estimates, hints);
  const double degrees = degrees_of(estimates, kurtosis);
  const auto tails = [&](double ratio) { return chi_squared_tails(ratio * degrees, degrees); };
  Outcome outcome;
  outcome.measured =
      sum_of_squares(estimates, exact) / (variance * static_cast<double>(estimates.values.size()));
  outcome.expected = 1;
  outcome.accepted = [&] { return central_interval(tails, null.alpha, 0, 1000); };
  outcome.p = outcome.recorded = tails(outcome.measured).two_sided();
  outcome.measured_words =
      fmt::format("{}, whose mean squared error is {:.5g}: {:.4g} times the exact {:.5g}",
                  describe(estimates), outcome.measured * variance, outcome.measured, variance);
  outcome.name = "a ratio";
  return judge(outcome, null, hints);
}

double expect_proportion(const std::string& call, const std::string& event, std::uint64_t count,
                         std::uint64_t trials, double p, const Null& null, const Hints& hints) {
  const Tails tails = binomial_tails(count, trials, p);
  const auto size = static_cast<double>(trials);
  Outcome outcome;
  outcome.measured = static_cast<double>(count) / size;
  outcome.expected = p;
  outcome.accepted = [&] { return accepted_proportions(trials, p, null.alpha); };
  outcome.p = tails.two_sided();
  const double jump = std::max(0.0, tails.lower + tails.upper - 1), u = fresh_uniform();
  outcome.recorded = Tails{tails.lower - u * jump, tails.upper - (1 - u) * jump}.two_sided();
  outcome.measured_words =
      fmt::format("{}: {} of {} times {} ({:.4g})", call, count, trials, event, outcome.measured);
  outcome.name = "a proportion";
  return judge(outcome, null, hints);
}

}  // namespace mc::checks
