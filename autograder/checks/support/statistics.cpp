#include "checks/support/checks.hpp"

namespace mc::checks {
namespace {

struct Outcome {
  double measured = 0;                 ///< the statistic
  double expected = 0;                 ///< its mean under the null
  std::function<Interval()> accepted;  ///< its values that pass; only a failure needs it
  double p = 0;                        ///< two-sided
  double recorded = 0;                 ///< uniform under the null
  std::string measured_words;          ///< with n and replicates
  std::string name;                    ///< of the statistic: "a mean"
};

Likely hint_for(const Outcome& outcome, const Interval& accepted, const Hints& hints) {
  const Suspect* found = nullptr;
  for (const Suspect& suspect : hints.suspects) {
    // As close to the suspect as a correct value to the expected one; relative to it if positive.
    const bool ratio = accepted.low > 0 && suspect.value > 0;
    const double at = ratio ? outcome.measured * outcome.expected / suspect.value
                            : outcome.measured - suspect.value + outcome.expected;
    if (!(accepted.low <= at && at <= accepted.high)) continue;
    if (found != nullptr && found->hint != suspect.hint) return {};  // ambiguous
    found = &suspect;
  }
  return found == nullptr ? Likely{} : found->hint;
}

/// Records the p-value and returns it; ends the check if it is below alpha.
double judge(const Outcome& outcome, const Null& null, const Hints& hints) {
  record(protocol::RecordKind::p_value,
         protocol::text_of({null.words, outcome.recorded, null.alpha}));
  if (!(outcome.p >= null.alpha)) {
    const Interval accepted = outcome.accepted();
    fail(Failure{outcome.measured_words,
                 fmt::format("{} between {:.6g} and {:.6g}; {:.6g} on average", outcome.name,
                             accepted.low, accepted.high, outcome.expected),
                 fmt::format("{}: a correct answer lies outside once in {:.1g} runs", null.words,
                             1 / null.alpha),
                 hint_for(outcome, accepted, hints), hints.rule});
  }
  pass();
  return outcome.recorded;
}

std::string describe(const Replicates& estimates) {
  return estimates.n > 1 ? fmt::format("{}: {} replicates of {} samples each", estimates.call,
                                       estimates.values.size(), estimates.n)
                         : fmt::format("{}: {} values", estimates.call, estimates.values.size());
}

}  // namespace

double expect_mean(const Replicates& estimates, double exact, double variance, const Null& null,
                   const Hints& hints) {
  const auto replicates = static_cast<double>(estimates.values.size());
  double mean = 0;  // of the errors: a sum of many values near 1e9 would be rounded
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
      fmt::format("{}, whose mean {:.8g} is {:.1f} standard errors from {:.8g}",
                  describe(estimates), outcome.measured, mean / sigma, exact);
  outcome.name = "a mean";
  return judge(outcome, null, hints);
}

double expect_variance(const Replicates& estimates, double exact, double variance, double kurtosis,
                       const Null& null, const Hints& hints) {
  const auto count = static_cast<double>(estimates.values.size());
  const double degrees = 2 * count / (kurtosis - 1);
  const auto tails = [&](double ratio) { return chi_squared_tails(ratio * degrees, degrees); };
  Outcome outcome;
  for (const double value : estimates.values) {
    outcome.measured += (value - exact) * (value - exact) / (variance * count);
  }
  outcome.expected = 1;
  outcome.accepted = [&] { return central_interval(tails, null.alpha, 0, 1000); };
  outcome.p = outcome.recorded = tails(outcome.measured).two_sided();
  outcome.measured_words =
      fmt::format("{}, with an MSE of {:.5g}: {:.4g} times the exact {:.5g}", describe(estimates),
                  outcome.measured * variance, outcome.measured, variance);
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
  outcome.accepted = [&] {
    const auto of_whole = [&](double k) {
      return binomial_tails(static_cast<std::uint64_t>(k), trials, p);
    };
    const Interval counts = central_interval(of_whole, null.alpha, 0, size + 1);
    return Interval{std::floor(counts.low) / size, (std::floor(counts.high) - 1) / size};
  };
  outcome.p = tails.two_sided();
  Rng rng = side_rng();
  const double jump = std::max(0.0, tails.lower + tails.upper - 1), u = uniform(rng);
  outcome.recorded = Tails{tails.lower - u * jump, tails.upper - (1 - u) * jump}.two_sided();
  outcome.measured_words =
      fmt::format("{}: {} of {} times {} ({:.4g})", call, count, trials, event, outcome.measured);
  outcome.name = "a proportion";
  return judge(outcome, null, hints);
}

}  // namespace mc::checks
