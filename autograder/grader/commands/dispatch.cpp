#include "grader/commands/dispatch.hpp"

#include <unistd.h>
#include <cctype>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/list.hpp"
#include "grader/reports/report.hpp"

namespace mc::grader {
namespace {

bool is_here(const Layout& layout, const CommandEntry& command) {
  return std::filesystem::exists(layout.root / command.about);
}

void print_overview(const Layout& layout) {
  const bool is_handout = !std::filesystem::exists(layout.solutions());
  fmt::print("usage: ./lab COMMAND ...   (details: ./lab COMMAND --help)\n\n");
  for (const CommandEntry& command : command_list) {
    if ((command.for_instructors && is_handout) || !is_here(layout, command)) continue;
    fmt::print("  ./lab {:<10} {}\n", command.name, command.description);
  }
}

const CommandEntry& find_entry(const std::vector<Lab>& labs, const std::string& name) {
  std::vector<std::string> names;
  for (const CommandEntry& command : command_list) {
    if (command.name == name) return command;
    if (!command.name.empty()) names.emplace_back(command.name);
  }
  for (const Lab& lab : labs) {
    if (name != lab.name && name != lab.folder && name != std::to_string(lab.number)) continue;
    throw UsageError(fmt::format("'{0}' is a lab; did you mean './lab check {0}'?", name));
  }
  throw UsageError(fmt::format("no command '{}'; did you mean '{}'? ./lab --help lists them", name,
                               nearest(name, names)));
}

/// The command, if this program has it.
const Command* find_command(std::string_view name) {
  for (const Command& command : registered_commands()) {
    if (command.name == name) return &command;
  }
  return nullptr;
}

/// Replaces this process by the program that has all commands.
[[noreturn]] void run_course(const Layout& layout, char** words) {
  const std::string program = layout.course().string();
  execv(program.c_str(), words);
  throw MachineError(fmt::format("{} is not built: run ./lab setup", program));
}

int dispatch(char** argv) {
  std::vector<std::string> words;
  for (char** word = argv + 1; *word != nullptr; ++word) words.emplace_back(*word);
  Context context{read_layout(), {}};
  if (!words.empty() && (words[0] == "--help" || words[0] == "-h" || words[0] == "help")) {
    print_overview(context.layout);
    return 0;
  }
  if (!words.empty() && (words[0] == "--version" || words[0] == "version")) {
    fmt::print("Monte Carlo labs {}\n", context.layout.version);
    return 0;
  }
  const CommandEntry& entry = find_entry(find_labs(context.layout), words.empty() ? "" : words[0]);
  if (!is_here(context.layout, entry)) {
    throw UsageError(fmt::format("./lab {} needs {}, which is not here", entry.name, entry.about));
  }
  const Command* const command = find_command(entry.name);
  if (command == nullptr) run_course(context.layout, argv);
  const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
  if (!rest.empty() && (rest[0] == "--help" || rest[0] == "-h")) {
    std::string description(entry.description);
    description[0] = static_cast<char>(std::toupper(description[0]));
    fmt::print("usage: ./lab {}\n\n{}.\n{}", command->usage, description, command->details);
    return 0;
  }
  const bool wants_json = std::any_of(
      rest.begin(), rest.end(), [](const std::string& word) { return word.starts_with("--json"); });
  if (wants_json && report_json == nullptr) run_course(context.layout, argv);
  const Arguments arguments =
      parse_arguments(rest, {command->options, command->words_before_verbatim});
  context.labs = find_labs(context.layout);
  return command->run(context, arguments);
}

}  // namespace

int run_lab(char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  try {
    return dispatch(argv);
  } catch (const UsageError& error) {
    fmt::print(stderr, "lab: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {  // MachineError, a full disk, no more processes
    fmt::print(stderr, "lab: {}\n", error.what());
    return 3;
  }
}

}  // namespace mc::grader
