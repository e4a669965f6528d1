#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

using experiments::ByLab1;

/// What lab 1 makes of the values, if it can say: what is built on it may be wrong because of it.
ByLab1 lab_1_of(const Values& values) {
  const auto got = TRY_MEASURE(by_lab_1, values);
  return got ? got->value : ByLab1{nan, nan, nan, nan, nan, nan, nan};
}

std::string blame(const std::string& function, const std::string& task) {
  return fmt::format(
      "the cause is in lab 1: this is what {} gives for these values; correct {} first", function,
      task);
}

/// Those of a task first.
std::vector<Suspect> joined(const Results::FindSuspects& first, std::vector<Suspect> others) {
  if (!first) return others;
  std::vector<Suspect> all = first();
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::vector<Suspect> mean_suspects(const Values& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = static_cast<double>(exact_mean(values));
  double in_whole_numbers = 0, without_negative = 0, sizes = 0;
  for (const double one : values) {
    in_whole_numbers = std::trunc(in_whole_numbers + one);
    without_negative += std::max(one, 0.0) / n;
    sizes += std::abs(one) / n;
  }
  const ByLab1 by = lab_1_of(values);
  return {{by.mean, blame("mean()", "1.1")},
          {by.mean_of_add, blame("add() with all", "1.4")},
          {by.mean_of_moments, blame("moments()", "1.8")},
          {mean * n, "this is the sum: divide it by n"},
          {in_whole_numbers / n,
           "the values were added up in an int: std::accumulate(..., 0.0) begins with a double"},
          {mean * n / (n - 1), "this divides by n - 1; only a variance does"},
          {mean * n / (n + 1), "this divides by n + 1"},
          {values.back(), "this is g at the last point alone: add up all of them"},
          {values.front(), "this is g at the first point alone: add up all of them"},
          {(mean * n - values.back()) / n, "the last value is not in the sum"},
          {(mean * n - values.front()) / n, "the first value is not in the sum"},
          {without_negative, "values below 0 count, too"},
          {sizes, "values below 0 count as what they are, not by their size"}};
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
           "this comes from variance_textbook(), which shows how the textbook formula fails: it "
           "keeps no digit of values far from 0"},
          {s * s / n, "this is the variance of the mean: take the square root"},
          {s, "this is s, the spread of one value: the mean of n has s / sqrt(n)"},
          {s * s, "this is s^2, the variance of one value: the mean of n has s / sqrt(n)"},
          {s / n, "this is s / n: it is the variance that falls as 1 / n, its root as 1 / sqrt(n)"},
          {s / std::sqrt(n) * std::sqrt((n - 1) / n),
           "s^2 has n - 1 below it: the values lie closer to their own mean than to the true one"},
          {s / std::sqrt(n - 1), "s^2 / n, not s^2 / (n - 1): one n - 1 is enough"},
          {std::sqrt((mean * mean + exact.variance * (n - 1) / n) / n),
           "this is the mean of squares: E{X}^2 is not taken off"},
          {std::sqrt(static_cast<double>(exact.m2)), "this is not divided at all"}};
}

}  // namespace

Traced traced(const Function& g, std::uint64_t n, Rng& rng) {
  const auto measured = MEASURE(traces, g, n, rng(), 1);
  const std::size_t dims = dims_of(g);
  const experiments::Traces* seen = nullptr;
  for (const std::size_t evaluations : {n, n + 1, n - 1}) {
    if (seen != nullptr || evaluations == 0) break;
    seen = measured.if_exactly({1, evaluations * dims, evaluations}, any_number);
  }
  if (seen == nullptr && measured.if_exactly({1, 0, 0}, any_number) != nullptr) {
    expect_that(false, measured.call + " never evaluated g", fmt::format("{} evaluations", n),
                "an estimate rests on values of g", "evaluate g once per sample");
  }
  if (seen == nullptr) {
    seen = &measured.list_by_list({{1, any_number}, {n * dims, any_number}, {n, any_number}});
  }
  const std::size_t evaluations = seen->values.size();
  measured.list_by_list({{1, any_number}, {evaluations * dims, unit}, {evaluations, finite}});
  return {measured.call, seen->estimates[0], seen->values, seen->points};
}

void add_mean(Results& means, const Traced& seen, Results::FindSuspects suspects) {
  double sizes = 0;
  for (const double one : seen.values) sizes += std::abs(one);
  means.add(seen.call + ".value", seen.estimate.value, static_cast<double>(exact_mean(seen.values)),
            10 * eps * sizes, [=] { return joined(suspects, mean_suspects(seen.values)); });
}

void judge_means(Results& means) {
  means.expect(
      "n additions lose at most n eps of the sum of sizes, in any order; one digit less is enough",
      "the mean of the very values that g gave; NaN comes from 0/0, or from a variable that "
      "nothing "
      "was written to");
}

void add_error(Results& errors, const Traced& seen, Results::FindSuspects suspects) {
  if (seen.values.size() < 2) {
    return errors.add(seen.call + ".standard_error", seen.estimate.standard_error, nan, 0);
  }
  const auto exact = exact_moments(seen.values);
  const double n = exact.count, mean = static_cast<double>(exact.mean);
  // A one-pass variance loses (n + kappa) eps of s^2 (lab 1); one digit less is enough.
  const double kappa = std::sqrt(1 + mean * mean / exact.variance);
  errors.add_digits(seen.call + ".standard_error", seen.estimate.standard_error,
                    std::sqrt(exact.variance / n),
                    std::min(16.0, -std::log10((n + kappa) * eps)) - 1,
                    [=] { return joined(suspects, error_suspects(seen.values)); });
}

void judge_errors(Results& errors) {
  errors.expect(
      "s / sqrt(n) of the values that were seen; lab 1's variances keep so many digits",
      "the square root of (sample variance / n); are the values far from 0 a problem (lab 1)? A "
      "variance below 0 has no root: E{X^2} - E{X}^2 may be that");
}

}  // namespace mc::checks
