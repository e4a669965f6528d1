#pragma once
// A verb's words and options, taken apart by getopt_long.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mc::grader {

struct Arguments {
  std::vector<std::string> words;
  std::map<std::string, std::string> options;  ///< a flag's value is empty

  bool has(const std::string& option) const { return options.contains(option); }
  std::optional<std::string> get(const std::string& option) const;
  /// A whole number; throws UsageError for what is none.
  std::optional<std::uint64_t> number(const std::string& option) const;
};

/// `known` lists the options: "seed=" takes a value, "no-plots" does not, "jobs=j" has a short
/// form. With `as_they_come`, options end at the first word (for words that may be negative
/// numbers). Throws UsageError for an option that is not known, naming the nearest, or that lacks
/// its value.
Arguments parse_arguments(const std::vector<std::string>& words,
                          const std::vector<std::string>& known, bool as_they_come = false);

}  // namespace mc::grader
