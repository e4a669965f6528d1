#include "grader/commands/command.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <utility>

#include "grader/commands/list.hpp"
#include "grader/reports/report.hpp"

namespace mc::grader {
namespace {

std::vector<Command>& registry() {
  static std::vector<Command> commands;
  return commands;
}

bool is_here(const Layout& layout, const CommandEntry& command) {
  return fs::exists(layout.root / command.about);
}

void print_overview(const Layout& layout) {
  const bool is_handout = !fs::exists(layout.solutions());
  fmt::print("usage: ./lab COMMAND ...   (details: ./lab COMMAND --help)\n\n");
  for (const CommandEntry& command : command_list) {
    if ((command.for_instructors && is_handout) || !is_here(layout, command)) continue;
    fmt::print("  ./lab {:<10} {}\n", command.name, command.description);
  }
}

/// The description, the details, and a table of the options.
void print_help(const Command& command, std::string description) {
  constexpr std::size_t width = 80;
  description[0] = static_cast<char>(std::toupper(description[0]));
  fmt::print("usage: {}\n\n{}.\n", wrapped("./lab " + command.usage, width - 7, 7), description);
  for (std::size_t begin = 0; begin < command.details.size();) {
    const auto end = std::min(command.details.find('\n', begin), command.details.size());
    fmt::print("{}\n", wrapped(command.details.substr(begin, end - begin), width, 0));
    begin = end + 1;
  }
  if (!command.options.empty()) fmt::print("\n");
  std::size_t longest = 0;
  for (const CommandOption& one : command.options) {
    longest = std::max(longest, columns_of(one.shown));
  }
  for (const CommandOption& one : command.options) {
    fmt::print("  {:<{}}  {}\n", one.shown, longest,
               wrapped(one.help, width - longest - 4, longest + 4));
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
[[noreturn]] void run_course(const Layout& layout, std::vector<std::string> words) {
  const std::string program = layout.course().string();
  if (!fs::exists(program)) {
    throw MachineError(fmt::format("{} is not built: run ./lab setup", program));
  }
  words.insert(words.begin(), program);
  execute(std::move(words));
}

int dispatch(std::vector<std::string> words) {
  Context context{read_layout(), {}};
  const Layout& layout = context.layout;
  const std::string name = words.empty() ? "" : words[0];
  if (name == "--help" || name == "-h" || name == "help") {
    print_overview(layout);
    return 0;
  }
  if (name == "--version" || name == "version") {
    fmt::print("Monte Carlo labs {}\n", layout.version);
    return 0;
  }
  context.labs = find_labs(layout);
  const CommandEntry& entry = find_entry(context.labs, name);
  if (!is_here(layout, entry)) {
    throw UsageError(fmt::format("./lab {} needs {}, which is not here", entry.name, entry.about));
  }
  const Command* const command = find_command(entry.name);
  const bool needs_course =
      command == nullptr || (report_json == nullptr && std::ranges::any_of(words, [](auto& word) {
                               return word.starts_with("--json");
                             }));
  if (needs_course) run_course(layout, std::move(words));
  if (!words.empty()) words.erase(words.begin());
  if (!words.empty() && words[0] == "-h") words[0] = "--help";
  const Arguments arguments = command->parse(words);
  if (arguments.has("help")) {
    print_help(*command, std::string(entry.description));
    return 0;
  }
  try {
    const std::size_t count = arguments.words.size();
    if (count < command->least_words || count > command->most_words) throw WrongUsage();
    return command->run(context, arguments);
  } catch (const WrongUsage&) {
    throw UsageError(
        fmt::format("usage: ./lab {} (details: ./lab {} --help)", command->usage, command->name));
  }
}

}  // namespace

Arguments Command::parse(const std::vector<std::string>& words) const {
  Syntax syntax{{}, words_before_verbatim};
  for (const CommandOption& one : options) syntax.options.push_back(one.shown);
  return parse_arguments(words, syntax);
}

RegisterCommand::RegisterCommand(Command command) {
  registry().push_back(std::move(command));
}

const std::vector<Command>& registered_commands() {
  return registry();
}

int run_lab(char** argv) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  std::vector<std::string> words;
  for (char** word = argv + 1; *word != nullptr; ++word) words.emplace_back(*word);
  try {
    return dispatch(std::move(words));
  } catch (const UsageError& error) {
    fmt::print(stderr, "lab: {}\n", error.what());
    return 2;
  } catch (const std::exception& error) {  // MachineError, a full disk, no more processes
    fmt::print(stderr, "lab: {}\n", error.what());
    return 3;
  }
}

void execute(std::vector<std::string> command) {
  std::vector<char*> pointers;
  for (std::string& word : command) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execvp(pointers[0], pointers.data());
  throw MachineError(fmt::format("cannot run {}", command[0]));
}

std::vector<Submission> submissions_with_solutions(const Context& context, const Lab& lab,
                                                   const std::vector<std::string>& directories) {
  const Layout& layout = context.layout;
  std::vector<Submission> submissions;
  const auto add = [&](const fs::path& directory, const char* label) {
    submissions.push_back(open_submission(context.labs, directory));
    if (label != nullptr) submissions.back().label = label;
  };
  for (const std::string& directory : directories) add(directory, nullptr);
  if (submissions.empty()) add(layout.starter(), "starter");
  const bool has_solutions =
      std::ranges::any_of(submissions, [&](auto& one) { return is_reference(layout, one); });
  if (!has_solutions && fs::exists(layout.solutions() / lab.file())) {
    add(layout.solutions(), "solutions");
  }
  return submissions;
}

}  // namespace mc::grader
