#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

using experiments::ByLab1;

/// The results of the submission's lab 1 for these values: possible causes of a wrong result.
ByLab1 lab_1_of(const Values& values) {
  const auto got = TRY_MEASURE(by_lab_1, values);
  return got ? got->value : ByLab1{nan, nan, nan, nan, nan, nan, nan};
}

std::string blame(const std::string& function, const std::string& task) {
  return fmt::format(
      "the cause is in lab 1: {} gives this result for these values; correct {} first", function,
      task);
}

std::vector<Suspect> joined(const Results::FindSuspects& first,
                            const std::vector<Suspect>& others) {
  std::vector<Suspect> all = first ? first() : std::vector<Suspect>();
  append(all, others);
  return all;
}

std::vector<Suspect> mean_suspects(const Values& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = static_cast<double>(exact_mean(values));
  double without_negative = 0, sizes = 0;
  for (const double one : values) {
    without_negative += std::max(one, 0.0) / n;
    sizes += std::abs(one) / n;
  }
  const ByLab1 by = lab_1_of(values);
  return {{by.mean, blame("mean()", "1.1")},
          {by.mean_of_add, blame("add() with all", "1.4")},
          {by.mean_of_moments, blame("moments()", "1.8")},
          {mean * n, "this is the sum: divide it by n"},
          {integer_sum(values) / n,
           "the values were added up in an int: start with a double, std::accumulate(…, 0.0)"},
          {mean * n / (n - 1), "this divides by n - 1; only a variance does"},
          {mean * n / (n + 1), "this divides by n + 1"},
          {values.back(), "this is only g at the last point: add up all values"},
          {values.front(), "this is only g at the first point: add up all values"},
          {(mean * n - values.back()) / n, "the last value is not in the sum"},
          {(mean * n - values.front()) / n, "the first value is not in the sum"},
          {without_negative, "negative values are missing"},
          {sizes, "these are absolute values: keep the signs"}};
}

std::vector<Suspect> error_suspects(const Values& values) {
  const auto exact = exact_moments(values);
  const double n = exact.count, s = std::sqrt(exact.variance);
  const double mean = static_cast<double>(exact.mean);
  const ByLab1 by = lab_1_of(values);
  return {{std::sqrt(by.variance_of_add / n), blame("variance() of add()", "1.4")},
          {std::sqrt(by.variance_two_pass / n), blame("variance_two_pass()", "1.3")},
          {std::sqrt(by.variance_of_moments / n), blame("variance() of moments()", "1.8")},
          {std::sqrt(by.variance_textbook / n),
           "this is E{X^2} - E{X}^2, which loses digits: use another variance of lab 1"},
          {s * s / n, "this is the variance of the mean: take the square root"},
          {s, "this is s, the standard deviation of one value: that of the mean is s / sqrt(n)"},
          {s * s,
           "this is s^2, the variance of one value: the standard error of the mean is s / sqrt(n)"},
          {s / n, "this is s / n: the variance falls as 1 / n, its square root as 1 / sqrt(n)"},
          {s / std::sqrt(n) * std::sqrt((n - 1) / n),
           "s^2 divides by n - 1: the values are closer to their own mean than to the true one"},
          {s / std::sqrt(n - 1), "this divides s^2 by n - 1: divide it by n"},
          {std::sqrt((mean * mean + exact.variance * (n - 1) / n) / n),
           "this uses the mean of squares: subtract E{X}^2"},
          {std::sqrt(static_cast<double>(exact.m2)),
           "this is the root of the sum of squared deviations: divide the sum by (n - 1) n"}};
}

}  // namespace

Trace traced(const Function& g, std::uint64_t n, Rng& rng) {
  const auto measured = MEASURE(traces, g, n, rng(), 1);
  const std::size_t dims = dims_of(g);
  const experiments::Traces* seen = nullptr;
  for (const std::size_t evaluations : {n, n + 1, n - 1}) {
    if (seen != nullptr || evaluations == 0) break;
    seen = measured.if_exactly({1, evaluations * dims, evaluations}, any_number);
  }
  if (seen == nullptr && measured.if_exactly({1, 0, 0}, any_number) != nullptr) {
    expect_that(false, measured.call + " never evaluated g", fmt::format("{} evaluations", n),
                "an estimate is a mean of values of g", "evaluate g once per sample");
  }
  if (seen == nullptr) {
    seen = &measured.list_by_list({{1, any_number}, {n * dims, any_number}, {n, any_number}});
  }
  const std::size_t evaluations = seen->values.size();
  measured.list_by_list({{1, any_number}, {evaluations * dims, unit}, {evaluations, finite}});
  return {measured.call, seen->estimates[0], seen->values, seen->points};
}

void add_mean(Results& means, const Trace& seen, Results::FindSuspects suspects) {
  double sizes = 0;
  for (const double one : seen.values) sizes += std::abs(one);
  means.add(seen.call + ".value", seen.estimate.value, static_cast<double>(exact_mean(seen.values)),
            10 * eps * sizes, [=] { return joined(suspects, mean_suspects(seen.values)); });
}

void judge_means(Results& means, const std::string& of) {
  means.expect(
      "n additions lose at most n eps of the sum of absolute values; one digit of slack",
      "return the mean of all values of " + of + ", n in all: do not limit or leave out any");
}

void add_error(Results& errors, const Trace& seen, Results::FindSuspects suspects) {
  if (seen.values.size() < 2) {
    return errors.add(seen.call + ".standard_error", seen.estimate.standard_error, nan, 0);
  }
  const auto exact = exact_moments(seen.values);
  // A one-pass variance loses (n + kappa) eps of s^2 (lab 1); one digit of slack.
  const double n = exact.count, kappa = condition(exact);
  errors.add_digits(seen.call + ".standard_error", seen.estimate.standard_error,
                    std::sqrt(exact.variance / n),
                    std::min(16.0, -std::log10((n + kappa) * eps)) - 1,
                    [=] { return joined(suspects, error_suspects(seen.values)); });
}

void judge_errors(Results& errors) {
  errors.expect(
      "s / sqrt(n) of the values of g, with the digits that lab 1's variances keep",
      "return sqrt(sample variance / n), NaN for n = 1; E{X^2} - E{X}^2 loses digits (lab 1)");
}

}  // namespace mc::checks
