#pragma once
// The commands of ./lab. Each is a file that registers itself; list.hpp says which program has it.

#include <string>
#include <vector>

#include "grader/checkout/context.hpp"
#include "grader/commands/arguments.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

/// A command takes the words after its name, writes to standard output, and returns its exit
/// status: 0, or 1 if `check` finds points missing. Bad usage and a missing machine feature are
/// thrown (errors.hpp).
struct Command {
  std::string name;                  ///< as list.hpp has it
  std::string usage;                 ///< "check LAB [DIR] [--seed S]"
  std::vector<std::string> options;  ///< as arguments.hpp has them
  std::string details;               ///< the rest of its --help
  int (*run)(const Context& context, const Arguments& arguments);
  /// After this many words, everything is a word: there may be negative numbers.
  std::size_t words_before_verbatim = all_words;
};

/// Makes a command known to the program that it is linked into.
struct RegisterCommand {
  explicit RegisterCommand(Command command);
};

/// The commands of this program.
const std::vector<Command>& registered_commands();

/// Submissions to draw side by side: these directories (or the starter), and the solutions if the
/// checkout has this lab's.
std::vector<Submission> submissions_with_solutions(const Context& context, const Lab& lab,
                                                   const std::vector<std::string>& directories);

}  // namespace mc::grader
