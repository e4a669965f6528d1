#include "suspects.hpp"

#include <cmath>
#include <span>

#include <fmt/format.h>

#include "checks/support/domain.hpp"

namespace mc::checks {
namespace {

/// One pass of sums about a shift.
struct About {
  double mean, m2;
};
About about(std::span<const double> x, double shift) {
  double sum = 0, squares = 0;
  for (const double value : x) {
    sum += value - shift;
    squares += (value - shift) * (value - shift);
  }
  const auto n = static_cast<double>(x.size());
  return {shift + sum / n, squares - sum * sum / n};
}

double sum_of(std::span<const double> x) {
  double sum = 0;
  for (const double value : x) sum += value;
  return sum;
}

/// std::accumulate(…, 0): every partial sum is cut off to a whole number.
double sum_in_whole_numbers(std::span<const double> x) {
  double sum = 0;
  for (const double value : x) sum = std::trunc(sum + value);
  return sum;
}

std::string about_value(const char* which) {
  return fmt::format(
      "these are the digits of sums about the {} value, which may lie far from all others", which);
}
const std::string large_numbers =
    "these are the digits that E{X^2} - E{X}^2 gives: two large numbers, nearly equal";
const std::string in_whole_numbers =
    "this has a mean in it that was added up in whole numbers: std::accumulate(…, 0) adds in int; "
    "begin with 0.0";

/// The sums of squared deviations of other ways, right and wrong.
std::vector<Suspect> ways_to_m2(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  const double sum = sum_of(x), mean = sum / n;
  double squares = 0, uncorrected = 0, about_first = 0;
  for (const double value : x) {
    squares += value * value;
    uncorrected += (value - mean) * (value - mean);
    about_first += (value - x[0]) * (value - x[0]);
  }
  double running = 0, count = 0, welford = 0, from_old_means = 0, from_new_means = 0;
  for (const double value : x) {
    const double before = value - running;
    running += before / ++count;
    const double after = value - running;
    welford += before * after;
    from_old_means += before * before;
    from_new_means += after * after;
  }
  const double whole = sum_in_whole_numbers(x) / n;
  return {
      {(squares / n - mean * mean) * n, large_numbers},
      {squares - sum * sum / n, large_numbers},
      {uncorrected, "the mean was rounded: take (sum of deviations)^2 / n off the sum of squares"},
      {welford, "these are the digits of a running mean, rounded at every step: 1.4's"},
      {from_old_means, "m2 grows by (x - old mean)(x - new mean); this is the old one, twice"},
      {from_new_means, "m2 grows by (x - old mean)(x - new mean); this is the new one, twice"},
      {about_first,
       "the mean never moves from the first value: is 1 / count an integer division, which is 0?"},
      {about(x, x.front()).m2, about_value("first")},
      {about(x, x.back()).m2, about_value("last")},
      {about(x, x[x.size() / 2]).m2, about_value("middle")},
      {squares / n * (n - 1), "this is E{X^2}: take E{X}^2 off"},
      {squares, "this is E{X^2} n/(n-1): the mean is not in it"},
      {squares - n * whole * whole, in_whole_numbers},
      {squares - 2 * whole * sum + n * whole * whole, in_whole_numbers}};
}

}  // namespace

double two_pass_here(const Values& x) {
  const auto n = static_cast<double>(x.size());
  return about(x, sum_of(x) / n).m2 / (n - 1);
}

std::vector<Suspect> mean_suspects(const List& list) {
  const auto mean = static_cast<double>(list.exact.mean);
  const double n = list.exact.count;
  return {{sum_in_whole_numbers(list.x) / n,
           "the sum is cut off to a whole number at each step: std::accumulate(…, 0) adds in int; "
           "begin with 0.0"},
          {mean * n / (n - 1), "this divides by n - 1; only the variance does"},
          {mean * n, "this is the sum: divide it by the count"},
          {list.x[0],
           "the mean stays at the first value: is 1 / count an integer division, which is 0?"},
          {n == 1 ? domain::infinity : domain::not_a_number,
           "the first value was divided by a count of 0: count it before"},
          {about(list.x, list.x.front()).mean, about_value("first")},
          {about(list.x, list.x.back()).mean, about_value("last")},
          {about(list.x, list.x[list.x.size() / 2]).mean, about_value("middle")}};
}

std::vector<Suspect> variance_suspects(const List& list) {
  std::vector<Suspect> all = ways_to_m2(list.x);
  const double n = list.exact.count, variance = list.exact.variance;
  for (Suspect& way : all) way.value /= n - 1;
  all.push_back({variance * (n - 1) / n,
                 "this divides by n; a sample variance divides by n - 1 (and n/(n-1) of whole "
                 "numbers is 1)"});
  all.push_back({variance * n / (n - 1), "n/(n-1) is in here twice: once is enough"});
  all.push_back({variance * (n - 1), "this is the sum of squared deviations, not divided yet"});
  all.push_back(
      {std::sqrt(variance), "this is the standard deviation: the variance is its square"});
  all.push_back({-variance, "the sign is wrong: E{X^2} is the larger one"});
  return all;
}

std::vector<Suspect> m2_suspects(const List& list) {
  std::vector<Suspect> all = ways_to_m2(list.x);
  const double n = list.exact.count, variance = list.exact.variance;
  all.push_back({variance, "m2 is a sum: variance() divides it, once"});
  all.push_back({variance * n, "this is n times the sample variance: m2 is n - 1 times it"});
  return all;
}

}  // namespace mc::checks
