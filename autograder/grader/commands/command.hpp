#pragma once
// What ./lab can do. A command is a file that registers itself; which program has it, stands in
// list.hpp.

#include <string>
#include <vector>

#include "grader/checkout/context.hpp"
#include "grader/commands/arguments.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

/// A command takes the words behind its name, writes to standard output and gives back its exit
/// status: 0, or 1 where `check` finds points missing. Bad usage and a lacking machine are thrown
/// (errors.hpp).
struct Command {
  std::string name;                  ///< as list.hpp has it
  std::string usage;                 ///< "check LAB [DIR] [--seed S]"
  std::vector<std::string> options;  ///< as arguments.hpp has them
  std::string details;               ///< the rest of its --help
  int (*run)(const Context& context, const Arguments& arguments);
  /// Behind so many words all that follows is words: there may be negative numbers among them.
  std::size_t words_before_verbatim = all_words;
};

/// Makes a command known to the program that it is linked into.
struct RegisterCommand {
  explicit RegisterCommand(Command command);
};

/// Those of this program.
const std::vector<Command>& registered_commands();

/// What is drawn side by side: these directories (the starter, where there are none), and the
/// solutions, where the checkout has this lab's.
std::vector<Submission> submissions_beside(const Context& context, const Lab& lab,
                                           const std::vector<std::string>& directories);

}  // namespace mc::grader
