#pragma once
// A command's words and options, taken apart by getopt_long.

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
  /// A whole number; throws UsageError for what is none.
  std::optional<std::uint64_t> number(const std::string& option) const;
};

/// For parse_arguments(): options may stand anywhere.
inline constexpr std::size_t all_words = std::numeric_limits<std::size_t>::max();

/// `known` lists the options: "seed=" takes a value, "no-plots" does not, "jobs=j" has a short
/// form, "lab=," may be given again and is a list then. Behind `before_verbatim` words everything
/// is a word, for words that may be negative numbers. Throws UsageError for an option that is not
/// known, naming the nearest, or that lacks its value.
Arguments parse_arguments(const std::vector<std::string>& words,
                          const std::vector<std::string>& known,
                          std::size_t before_verbatim = all_words);

}  // namespace mc::grader
