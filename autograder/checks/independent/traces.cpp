#include "checks/independent/traces.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "checks/support/exact.hpp"

namespace mc::checks {
namespace {

using experiments::ByLab1;
using experiments::Traces;

/// Of lists that passed for their sizes: their range.
void require_range(const std::string& call, const std::string& name, const Values& list,
                   const Range& range) {
  if (const auto what = list_objection(name, list, list.size(), false, range)) refuse(call, *what);
}

const std::string moves_on = "the generator must move on: is it copied somewhere?";

/// The first coordinate of each point.
Values every(const Values& coordinates, std::size_t dims) {
  Values all;
  for (std::size_t i = 0; i < coordinates.size(); i += dims) all.push_back(coordinates[i]);
  return all;
}

double half(std::size_t size) {
  return static_cast<double>(size) / 2;
}

std::ptrdiff_t signed_size(std::size_t size) {
  return static_cast<std::ptrdiff_t>(size);
}

/// Numbers that occur more than once, counted each time but the first.
double repeated(Values& numbers) {
  std::sort(numbers.begin(), numbers.end());
  double count = 0;
  for (std::size_t i = 1; i < numbers.size(); ++i) count += numbers[i] == numbers[i - 1] ? 1 : 0;
  return count;
}

/// What lab 1 makes of the values, if it can say: what is built on it may be wrong because of it.
std::optional<ByLab1> lab_1_of(std::span<const double> values) {
  const auto got = TRY_MEASURE(by_lab_1, Values(values.begin(), values.end()));
  if (!got) return {};
  return got->value;
}

std::string blame(const std::string& function, double got, double exact, const std::string& task) {
  return fmt::format(
      "it is lab 1's: {} of these values gives {:.8g}, where {:.8g} is right; mend {} first",
      function, got, exact, task);
}

/// Means that lab 1 gives.
std::vector<Suspect> means_by_lab_1(std::span<const double> values, double exact) {
  const auto by = lab_1_of(values);
  if (!by) return {};
  return {{by->mean, blame("mean()", by->mean, exact, "1.1")},
          {by->mean_of_add, blame("add() with all", by->mean_of_add, exact, "1.4")},
          {by->mean_of_moments, blame("moments()", by->mean_of_moments, exact, "1.8")}};
}

/// Standard errors that follow from lab 1's variances, where those have fewer digits than `floor`.
std::vector<Suspect> errors_by_lab_1(std::span<const double> values, double exact, double floor) {
  const auto by = lab_1_of(values);
  if (!by) return {};
  std::vector<Suspect> suspects;
  const auto n = static_cast<double>(values.size());
  for (const auto& [name, variance, task] :
       {std::tuple{"variance() of add()", by->variance_of_add, "1.4"},
        {"variance_two_pass()", by->variance_two_pass, "1.3"},
        {"variance() of moments()", by->variance_of_moments, "1.8"}}) {
    if (!(variance >= 0) || digits(std::sqrt(variance), std::sqrt(exact)) >= floor) continue;
    suspects.push_back({std::sqrt(variance / n), blame(name, variance, exact, task)});
  }
  if (by->variance_textbook >= 0) {
    suspects.push_back({std::sqrt(by->variance_textbook / n),
                        "this comes from variance_textbook(), which shows how the textbook formula "
                        "fails: it keeps no digit of values far from 0"});
  }
  return suspects;
}

/// The first of two lists, then the other.
std::vector<Suspect> joined(std::vector<Suspect> one, const std::vector<Suspect>& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

}  // namespace

void require_finite(const std::string& call, const Values& values) {
  require_range(call, "value", values, finite);
}

Traced::Traced(const Function& g, std::uint64_t n, Rng& rng, std::uint64_t replicates)
    : measured_(MEASURE(traces, g, n, rng(), replicates)) {
  const std::size_t dims = dims_of(g);
  const auto with = [&](std::size_t evaluations) {
    return measured_.if_exactly(
        {replicates, replicates * evaluations * dims, replicates * evaluations}, any_number);
  };
  for (const std::size_t evaluations : {n, n + 1, n - 1}) {
    if (traces_ != nullptr || evaluations == 0) break;
    traces_ = with(evaluations);
    evaluations_ = evaluations;
  }
  if (traces_ == nullptr && with(0) != nullptr) {
    expect_that(false, call() + " never evaluated g", fmt::format("{} evaluations", n),
                "an estimate rests on values of g", "evaluate g once a sample");
  }
  if (traces_ == nullptr) {
    traces_ = &measured_.exactly({replicates, replicates * n * dims, replicates * n}, any_number);
  }
  require_range(call(), "points", points(), unit);
  require_range(call(), "values", values(), finite);
  const Values first = every(points(), dims);
  expect_distinct(call(), "points", {first.begin(), first.begin() + signed_size(evaluations_)},
                  half(evaluations_),
                  "each sample is drawn anew: take new numbers from rng inside the loop");
  expect_distinct(call(), "points", first, half(first.size()), moves_on);
  const auto other = MEASURE(traces, g, n, rng(), 1);
  const Traces* const others = other.if_exactly({1, evaluations_ * dims, evaluations_}, any_number);
  expect_that(others != nullptr, other.call + " evaluated g another number of times",
              fmt::format("{} evaluations, as with another seed", evaluations_),
              "n is what the caller pays for", "evaluate g once a sample");
  require_range(other.call, "points", others->points, unit);
  expect_nothing_in_common(call(), "points", first, every(others->points, dims));
}

void expect_mean_of(const std::string& call, double value, std::span<const double> values,
                    const std::vector<Suspect>& suspects) {
  const auto n = static_cast<double>(values.size());
  const double mean = static_cast<double>(exact_mean(values));
  double sizes = 0;
  double in_whole_numbers = 0;
  for (const double one : values) {
    sizes += std::abs(one) / n;
    in_whole_numbers = std::trunc(in_whole_numbers + one);
  }
  const double tolerance = 10 * n * eps * sizes;
  if (std::abs(value - mean) <= tolerance) return pass();
  const auto unless_zero = [](double of_one) { return of_one == 0 ? nan : of_one; };
  const std::vector<Suspect> of_mean{
      {mean * n, "this is the sum: divide it by n"},
      {unless_zero(in_whole_numbers / n),
       "the values were added up in an int: std::accumulate(..., 0.0) begins with a double"},
      {mean * n / (n - 1), "this divides by n - 1; only a variance does"},
      {mean * n / (n + 1), "this divides by n + 1"},
      {unless_zero(values.back()), "this is g at the last point alone: add up all of them"},
      {unless_zero(values.front()), "this is g at the first point alone: add up all of them"},
      {(mean * n - values.back()) / n, "the last value is not in the sum"},
      {(mean * n - values.front()) / n, "the first value is not in the sum"}};
  expect_within(
      call + ".value", value, mean, tolerance,
      "n additions lose at most n eps of the sum of sizes, in any order; one digit less is enough",
      {joined(joined(means_by_lab_1(values, mean), suspects), of_mean),
       "the mean of the very values that g gave",
       "NaN comes of 0/0, or of a variable that nothing was written to"});
}

void expect_standard_error(const std::string& call, double standard_error,
                           std::span<const double> values, const std::vector<Suspect>& suspects) {
  if (values.size() < 2) {
    expect_nan(call + ".standard_error", standard_error, "one value says nothing about spread");
    return;
  }
  const auto exact = exact_moments(values);
  const double n = exact.count, s = std::sqrt(exact.variance);
  const double mean = static_cast<double>(exact.mean);
  // A one-pass variance loses (n + kappa) eps of s^2 (lab 1); one digit less is enough.
  const double kappa = std::sqrt(1 + mean * mean / exact.variance);
  const double floor = std::min(16.0, -std::log10((n + kappa) * eps)) - 1;
  if (digits(standard_error, s / std::sqrt(n)) >= floor) return pass();
  const auto by = lab_1_of(values);
  const std::string no_number =
      by && by->variance_textbook < 0
          ? "a variance below 0 has no root: this comes from variance_textbook(), or from its "
            "formula"
          : "a variance below 0 has no root; and is there an n = 1 in it?";
  const double root_mean_square = std::sqrt(mean * mean + exact.variance * (n - 1) / n);
  const std::vector<Suspect> of_s{
      {s * s / n, "this is the variance of the mean: take the square root"},
      {s, "this is s, the spread of one value: the mean of n has s / sqrt(n)"},
      {s * s, "this is s^2, the variance of one value: the mean of n has s / sqrt(n)"},
      {s / n, "this is s / n: it is the variance that falls as 1 / n, its root as 1 / sqrt(n)"},
      {s / std::sqrt(n) * std::sqrt((n - 1) / n),
       "s^2 has n - 1 below it: the values lie closer to their own mean than to the true one"},
      {s / std::sqrt(n - 1), "s^2 / n, not s^2 / (n - 1): one n - 1 is enough"},
      {root_mean_square / std::sqrt(n), "this is the mean of squares: E{X}^2 is not taken off"},
      {std::sqrt(static_cast<double>(exact.m2)), "this is not divided at all"}};
  expect_digits(
      call + ".standard_error", standard_error, s / std::sqrt(n), floor,
      fmt::format("the {} values have s = {:.6g}; lab 1's variances keep so many digits", n, s),
      {joined(joined(errors_by_lab_1(values, exact.variance, floor), suspects), of_s),
       "the square root of (sample variance / n); are the values far from 0 a problem (lab 1)?",
       no_number});
}

void expect_distinct(const std::string& call, const std::string& what, Values numbers, double most,
                     const std::string& hint) {
  const double count = repeated(numbers);
  expect_that(count <= most,
              fmt::format("{}: {} of {} {} came before", call, count, numbers.size(), what),
              "new ones each time", "independent numbers of 53 bits are hardly ever equal", hint);
}

void expect_nothing_in_common(const std::string& call, const std::string& what, Values numbers,
                              Values of_another_seed) {
  std::sort(numbers.begin(), numbers.end());
  std::sort(of_another_seed.begin(), of_another_seed.end());
  Values both;
  std::set_intersection(numbers.begin(), numbers.end(), of_another_seed.begin(),
                        of_another_seed.end(), std::back_inserter(both));
  const std::size_t all = std::min(numbers.size(), of_another_seed.size());
  expect_that(
      2 * both.size() <= all,
      fmt::format("{}: {} of {} {} are those of another seed, too", call, both.size(), all, what),
      "other numbers from another generator",
      "the generator that it is given is its only source of randomness",
      "take the numbers from rng, and from nowhere else");
}

void expect_new_numbers(const std::string& call, const Values& estimates) {
  for (std::size_t i = 1; i < estimates.size(); ++i) {
    if (estimates[i] != estimates[i - 1]) continue;
    expect_that(false, fmt::format("{}: two estimates in a row are {}", call, estimates[i]),
                "estimates that differ", "each goes on where the generator was left", moves_on);
  }
}

}  // namespace mc::checks
