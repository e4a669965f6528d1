#include "checks/support/validation.hpp"

#include <cmath>

#include <fmt/format.h>

#include "runner/text.hpp"

namespace mc::checks {

void fail(const Failure& failure) {
  std::string report =
      fmt::format("measured  {}\nexpected  {}", failure.measured, failure.expected);
  if (!failure.because.empty()) report += "\nbecause   " + failure.because;
  if (!failure.likely.empty()) report += "\nlikely    " + failure.likely;
  fail(report);
}

void refuse(const std::string& call, const Failure& failure) {
  fail(Failure{call + ' ' + failure.measured, failure.expected, failure.because, failure.likely});
}

Failure wrong_size(const std::string& list, std::size_t size, std::size_t expected, bool or_less) {
  return {fmt::format("gave {} values{}", size, list.empty() ? "" : " in " + list),
          fmt::format("{}{} values", or_less ? "at most " : "", expected), "",
          size == 0 ? "nothing was returned or filled in" : ""};
}

Failure wrong_value(const std::string& list, std::size_t index, double value, const Range& range) {
  const std::string likely =
      std::isnan(value) ? "this value was never written, or is 0/0"
      : value == range.high && range.below_high
          ? "it was rounded up to the upper end, which does not belong to the range"
          : "";
  return {fmt::format("gave {}[{}] = {}", list, index, value), range.words, "", likely};
}

std::vector<std::string> names_of(std::string_view fields) {
  std::vector<std::string> names;
  for (const std::string_view name : text::split(fields, ',')) names.emplace_back(name);
  return names;
}

}  // namespace mc::checks
