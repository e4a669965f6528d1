#include "checks/independent/functions.hpp"

namespace mc::checks {
namespace {

std::vector<Suspect> mean_suspects(const Values& values) {
  const auto n = static_cast<double>(values.size());
  const double mean = static_cast<double>(exact_mean(values));
  return {
      {integer_sum(values) / n,
       "the values were added up in an int: start with a double, std::accumulate(…, 0.0)"_likely},
      {mean * n / (n - 1), "this divides by n - 1; only a variance does"_likely},
      {(mean * n - values.back()) / n, "the last value is not in the sum"_likely}};
}

std::vector<Suspect> error_suspects(const Values& values) {
  const auto exact = exact_moments(values);
  const double n = exact.count, s = std::sqrt(exact.variance);
  return {
      {s * s / n, "this is the variance of the mean: take the square root"_likely},
      {s / n, "this is s / n: the variance falls as 1 / n, its square root as 1 / sqrt(n)"_likely},
      {s / std::sqrt(n) * std::sqrt((n - 1) / n),
       "s^2 divides by n - 1: the values are closer to their own mean than to "
       "the true one"_likely}};
}

}  // namespace

Trace traced(const Function& g, std::uint64_t n, Rng& rng) {
  const auto measured = MEASURE(traces, g, n, rng(), 1);
  const std::size_t dims = dims_of(g);
  const experiments::Traces* seen = nullptr;
  for (const std::size_t evaluations : {n, n + 1, n - 1, 2 * n}) {
    if (seen != nullptr || evaluations == 0) break;
    seen = measured.if_exactly({1, evaluations * dims, evaluations}, any_number);
  }
  expect_that(measured.if_exactly({1, 0, 0}, any_number) == nullptr,
              measured.call + " never evaluated g", fmt::format("{} evaluations", n),
              "an estimate is a mean of values of g", "evaluate g once per sample");
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
  means.add(
      seen.call + ".value", seen.estimate.value, static_cast<double>(exact_mean(seen.values)),
      10 * eps * sizes,
      suspects ? suspects : [values = seen.values] { return mean_suspects(values); });
}

void judge_means(Results& means, const std::string& of) {
  means.expect("n additions lose at most n eps of the sum of absolute values; one digit of slack",
               "return the mean of all " + of + ", n in all: do not limit or leave out any");
}

void add_error(Results& errors, const Trace& seen, Results::FindSuspects suspects) {
  if (seen.values.size() < 2) {
    return errors.add(seen.call + ".standard_error", seen.estimate.standard_error, nan, 0);
  }
  const auto exact = exact_moments(seen.values);
  // A one-pass variance loses (n + kappa) eps of s^2 (lab 1); one digit of slack.
  const double n = exact.count, kappa = condition(exact);
  errors.add_digits(
      seen.call + ".standard_error", seen.estimate.standard_error, std::sqrt(exact.variance / n),
      std::min(16.0, -std::log10((n + kappa) * eps)) - 1,
      suspects ? suspects : [values = seen.values] { return error_suspects(values); });
}

void judge_errors(Results& errors) {
  errors.expect(
      "s / sqrt(n) of the values of g, with the digits that lab 1's variances keep",
      "return sqrt(sample variance / n), NaN for n = 1; E{X^2} - E{X}^2 loses digits (lab 1)");
}

}  // namespace mc::checks
