#include "checks/support/validation.hpp"

#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "runner/text.hpp"

namespace mc::checks {

void fail(const Failure& failure) {
  auto report = fmt::format("measured  {}\nexpected  {}", failure.measured, failure.expected);
  if (!failure.because.empty()) report += "\nbecause   " + failure.because;
  const std::string& likely = failure.likely.text;
  if (!likely.empty()) report += "\nlikely    " + likely;
  if (likely.empty() && !failure.rule.empty()) report += "\nrule      " + failure.rule;
  fail(report);
}

void expect_that(bool holds, const std::string& measured, const std::string& expected,
                 const std::string& because, const std::string& rule, const Likely& likely) {
  if (!holds) fail(Failure{measured, expected, because, likely, rule});
  pass();
}

void expect_equal(const std::string& what, std::uint64_t got, std::uint64_t expected,
                  const std::string& because, const std::string& rule, const Likely& likely) {
  expect_that(got == expected, fmt::format("{} = {}", what, got), fmt::format("{}", expected),
              because, rule, likely);
}

void expect_nan(const std::string& what, double got, const std::string& because) {
  expect_that(std::isnan(got), fmt::format("{} = {}", what, got), "NaN", because,
              "return std::numeric_limits<double>::quiet_NaN() if the result is undefined");
}

void expect_not_finite(const std::string& what, double got, const std::string& because,
                       const std::string& hint) {
  expect_that(!std::isfinite(got), fmt::format("{} = {}", what, got), "inf or NaN", because, hint);
}

void refuse(const std::string& call, const Failure& failure) {
  fail(Failure{call + ' ' + failure.measured, failure.expected, failure.because, failure.likely});
}

Failure wrong_size(const std::string& list, std::size_t size, std::size_t expected, bool or_less) {
  return {fmt::format("gave {} values{}", size, list.empty() ? "" : " in " + list),
          fmt::format("{}{} values", or_less ? "at most " : "", expected), "",
          size == 0 ? "nothing was returned or filled in"_likely : Likely{}};
}

Failure wrong_value(const std::string& list, std::size_t index, double value, const Range& range) {
  const Likely likely =
      std::isnan(value) ? "this value was never written, or is 0/0"_likely
      : value == range.high && range.below_high
          ? "the upper end is not in the range: return at most the largest double below it"_likely
          : Likely{};
  return {fmt::format("gave {}[{}] = {}", list, index, value), range.words, "", likely};
}

std::vector<std::string> names_of(std::string_view fields) {
  std::vector<std::string> names;
  for (const std::string_view name : text::split(fields, ',')) names.emplace_back(name);
  return names;
}

std::string without_empty_signs(const std::string& report) {
  // Not in "1e-05", "-0.5" or "2^-0".
  static const std::regex sign(R"((^|[^A-Za-z0-9^])-(nan|0)(?![A-Za-z0-9]|\.[0-9]))");
  return std::regex_replace(report, sign, "$1$2");
}

}  // namespace mc::checks
