#pragma once
// A command's words and options, parsed by getopt_long.

#include <cstddef>
#include <cstdint>
#include <limits>
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
  /// A whole number; throws UsageError for anything else.
  std::optional<std::uint64_t> number(const std::string& option) const;
};

/// For Syntax: options may be anywhere.
inline constexpr std::size_t all_words = std::numeric_limits<std::size_t>::max();

/// "seed=" takes a value, "no-plots" does not, "jobs=j" has a short form, "lab=," may be repeated
/// and is then a list. After `words_before_verbatim`, everything is a word, because words may be
/// negative numbers.
struct Syntax {
  std::vector<std::string> options;
  std::size_t words_before_verbatim = all_words;
};
/// Throws UsageError for an unknown option, naming the nearest, or for a missing value.
Arguments parse_arguments(const std::vector<std::string>& words, const Syntax& syntax);

}  // namespace mc::grader
