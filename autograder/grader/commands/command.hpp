#pragma once
// The commands of ./lab. Each is a file that registers itself; list.hpp says which program has it.
// This header has what nearly every command needs.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/checkout/labs.hpp"
#include "grader/commands/arguments.hpp"
#include "grader/submission/submission.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

struct CommandOption {
  std::string shown;  ///< "--seed S", as arguments.hpp reads it
  std::string help;
};

/// A command takes the words after its name, writes to standard output, and returns its exit
/// status: 0, or 1 if `check` finds points missing. Bad usage and a missing machine feature are
/// thrown (errors.hpp).
struct Command {
  std::string usage = {};    ///< "check LAB [DIR] [--seed S]"; its first word is as list.hpp has it
  std::string details = {};  ///< paragraphs for --help
  std::vector<CommandOption> options = {};
  int (*run)(const Context& context, const Arguments& arguments) = nullptr;
  /// With fewer or more words, the command does not run: its usage is shown.
  std::size_t least_words = 0, most_words = any_number;
  /// After this many words, everything is a word: there may be negative numbers.
  std::size_t words_before_verbatim = any_number;
  std::string name = usage.substr(0, usage.find(' '));

  Arguments parse(const std::vector<std::string>& words) const;
};

/// Makes a command known to the program that it is linked into.
struct RegisterCommand {
  explicit RegisterCommand(Command command);
};

/// The commands of this program.
const std::vector<Command>& registered_commands();

/// Thrown by a command to show its usage.
struct WrongUsage : UsageError {
  WrongUsage() : UsageError("wrong usage") {}
};

/// Finds the command that ./lab was called with, runs it, and turns errors into a line and an exit
/// status. `argv` is that of main().
int run_lab(char** argv);

/// Replaces this process by another program. Returns only by throwing MachineError.
[[noreturn]] void execute(std::vector<std::string> command);

/// Submissions to draw side by side: these directories (or the starter), and the solutions if the
/// checkout has this lab's.
std::vector<Submission> submissions_with_solutions(const Context& context, const Lab& lab,
                                                   const std::vector<std::string>& directories);

}  // namespace mc::grader
