#pragma once
// Parses words that name a lab, or one of its tasks.

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/checkout/labs.hpp"

namespace mc::grader {

/// The lab in a task's number, "1" in "1.3"; nothing if the text is not a task's number.
inline std::optional<std::string> lab_of_task(const std::string& word) {
  const auto digits = [](const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  };
  const auto dot = word.find('.');
  if (dot == std::string::npos || !digits(word.substr(0, dot)) || !digits(word.substr(dot + 1))) {
    return {};
  }
  return word.substr(0, dot);
}

struct LabAndTask {
  const Lab& lab;
  std::string task;               ///< "1.3"; empty: all of them
  std::vector<std::string> rest;  ///< the words after them
};

/// Takes "variance", "1.3" or "variance 1.3" off the beginning of `words`, which must not be empty.
/// Throws UsageError for an unknown lab, and for a task of another lab.
inline LabAndTask lab_and_task(const std::vector<Lab>& labs,
                               const std::vector<std::string>& words) {
  const auto number = lab_of_task(words[0]);
  const Lab& lab = find_lab(labs, number.value_or(words[0]));
  LabAndTask meant{lab, number ? words[0] : "", {words.begin() + 1, words.end()}};
  if (number || meant.rest.empty()) return meant;
  if (const auto owner = lab_of_task(meant.rest[0])) {
    if (*owner != std::to_string(lab.number)) {
      throw UsageError(fmt::format("{} is not a task of lab {}", meant.rest[0], lab.name));
    }
    meant.task = meant.rest[0];
    meant.rest.erase(meant.rest.begin());
  }
  return meant;
}

}  // namespace mc::grader
