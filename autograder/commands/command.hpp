#pragma once
// The commands of ./lab. Each is a file that registers itself; nothing else lists them. This header
// has what nearly every command needs.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "commands/arguments.hpp"
#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/checkout/labs.hpp"
#include "judge/submission/submission.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;

struct CommandOption {
  std::string shown;  ///< "--seed S", as arguments.hpp reads it
  std::string help;
  std::string place = {};  ///< a path that it needs: without that, there is no such option
};

/// A command takes the words after its name, writes to standard output, and returns its exit
/// status: 0, or 1 if `check` finds points missing. Bad usage and a missing machine feature are
/// thrown (errors.hpp).
struct Command {
  std::string usage = {};    ///< "check LAB [DIR] [--seed S]"; its first word is the name
  std::string about = {};    ///< a line for ./lab --help
  std::string details = {};  ///< paragraphs for ./lab COMMAND --help
  std::vector<CommandOption> options = {};
  int (*run)(const Context& context, const Arguments& arguments) = nullptr;
  /// With fewer or more words, the command does not run: its usage is shown.
  std::size_t least_words = 0, most_words = any_number;
  /// After this many words, everything is a word: there may be negative numbers.
  std::size_t words_before_verbatim = any_number;
  bool for_instructors = false;  ///< listed only where there are solutions
  std::string place = {};        ///< the path it works on: without that, there is no such command
  /// The CMake targets that must be up to date before it runs, besides this program.
  std::vector<std::string> (*targets)(const Context& context, const Arguments& arguments) = nullptr;
  std::string name = usage.substr(0, usage.find(' '));

  Arguments parse(const std::vector<std::string>& words) const;
};

/// Makes a command known.
struct RegisterCommand {
  explicit RegisterCommand(Command command);
};

/// All commands, by name: those of students first.
const std::vector<Command>& all_commands();

/// Thrown by a command to show its usage.
struct WrongUsage : UsageError {
  WrongUsage() : UsageError("wrong usage") {}
};

/// Finds the command that ./lab was called with, brings what it needs up to date, runs it, and
/// turns errors into a line and an exit status. `argv` is that of main().
int run_lab(char** argv);

/// Replaces this process by another program. Returns only by throwing MachineError.
[[noreturn]] void execute(std::vector<std::string> command);

/// The target "PREFIX_LAB" of the lab that the first word names; none without one.
template <const char* prefix>
std::vector<std::string> target_of_lab(const Context& context, const Arguments& arguments) {
  if (arguments.words.empty()) return {};
  return {prefix + lab_and_task(context.labs, arguments.words).lab.name};
}
inline constexpr char checks_target[] = "checks_", experiments_target[] = "experiments_",
                      measure_target[] = "measure_";

/// "PREFIX_LAB" for every lab.
std::vector<std::string> targets_of_all(const Context& context, const std::string& prefix);

/// Submissions to draw side by side: these directories (or the starter), and the solutions if the
/// checkout has this lab's.
std::vector<Submission> submissions_with_solutions(const Context& context, const Lab& lab,
                                                   const std::vector<std::string>& directories);

}  // namespace mc::grader
