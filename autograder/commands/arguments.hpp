#pragma once
// A command's words and options, parsed by getopt_long, and what many commands read from them.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"

namespace mc::grader {

struct Arguments {
  std::vector<std::string> words;
  std::map<std::string, std::string> options;  ///< a flag's value is empty

  bool has(const std::string& option) const { return options.contains(option); }
  std::optional<std::string> get(const std::string& option) const;
  /// The words after the first `count`.
  std::vector<std::string> words_after(std::size_t count) const;
  /// A whole number; throws UsageError for anything else.
  std::optional<std::uint64_t> number(const std::string& option) const;
  /// The name of a file to write. Throws UsageError if its directory does not exist: before any
  /// work is done, so that a mistyped name costs no grading time.
  std::optional<std::string> output(const std::string& option) const;
  /// --seed, or a random seed, so that no answer can be fitted to it; short enough to type.
  std::uint64_t seed() const;
};

inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// Options as --help shows them: "--seed S" takes a value, "--no-plots" does not, "--jobs N, -j N"
/// has a short form, "--lab LAB,…" may be repeated and is then a list. After
/// `words_before_verbatim`, everything is a word, because words may be negative numbers.
struct Syntax {
  std::vector<std::string> options;
  std::size_t words_before_verbatim = any_number;
};
/// --help is an option, too. Throws UsageError for an unknown option, naming the nearest, or for a
/// missing value.
Arguments parse_arguments(const std::vector<std::string>& words, const Syntax& syntax);

struct LabAndTask {
  const Lab& lab;
  std::string task;               ///< "1.3"; empty: all of them
  std::vector<std::string> rest;  ///< the words after them
};

/// Takes "variance", "1.3" or "variance 1.3" off the beginning of `words`, which must not be empty.
/// Throws UsageError for an unknown lab, and for a task of another lab.
LabAndTask lab_and_task(const std::vector<Lab>& labs, const std::vector<std::string>& words);

}  // namespace mc::grader
