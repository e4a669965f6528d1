#include "commands/command.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <tuple>
#include <utility>

#include "judge/base/replace.hpp"
#include "judge/base/side_by_side.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/reports/report.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

std::vector<Command>& registry() {
  static std::vector<Command> commands;
  return commands;
}

bool is_here(const Layout& layout, const std::string& place) {
  return fs::exists(layout.root / place);
}

/// Without the options that cannot work here.
Command usable_part(const Layout& layout, Command command) {
  std::erase_if(command.options, [&](const CommandOption& one) {
    if (is_here(layout, one.place)) return false;
    command.usage = with_replacements(command.usage, {{fmt::format(" [{}]", one.shown), ""}});
    return true;
  });
  return command;
}

void print_overview(const Layout& layout) {
  const bool is_handout = !fs::exists(layout.solutions());
  fmt::print("usage: ./lab COMMAND ...   (details: ./lab COMMAND --help)\n\n");
  for (const Command& command : all_commands()) {
    if ((command.for_instructors && is_handout) || !is_here(layout, command.place)) continue;
    fmt::print("  ./lab {:<10} {}\n", command.name, command.about);
  }
}

/// The description, the details, and a table of the options.
void print_help(const Command& command) {
  constexpr std::size_t width = 80;
  std::string about = command.about;
  about[0] = static_cast<char>(std::toupper(about[0]));
  fmt::print("usage: {}\n\n{}.\n", wrapped("./lab " + command.usage, width - 7, 7), about);
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

Command find_command(const Context& context, const std::string& name) {
  std::vector<std::string> names;
  for (const Command& command : all_commands()) {
    if (command.name == name) {
      if (is_here(context.layout, command.place)) return usable_part(context.layout, command);
      throw UsageError(fmt::format("./lab {} needs {}, which is not here", name, command.place));
    }
    if (!command.name.empty()) names.push_back(command.name);
  }
  for (const Lab& lab : context.labs) {
    if (name != lab.name && name != lab.folder && name != std::to_string(lab.number)) continue;
    throw UsageError(fmt::format("'{0}' is a lab; did you mean './lab check {0}'?", name));
  }
  throw UsageError(fmt::format("no command '{}'; did you mean '{}'? ./lab --help lists them", name,
                               nearest(name, names)));
}

/// Builds these targets. Two builds in one directory would run every rule twice, so there is a
/// lock; a file system without locks does without.
void build(const Layout& layout, const std::vector<std::string>& targets) {
  const sandbox::Descriptor lock(
      open((layout.build / ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644),
      "opening the lock of " + layout.build.string());
  const ProgressLine line("building");
  (void)flock(lock.get(), LOCK_EX);
  std::vector<std::string> command{
      "cmake", "--build", layout.build.string(), "--parallel", std::to_string(cores()), "--target"};
  command.insert(command.end(), targets.begin(), targets.end());
  const auto run = sandbox::run_process(command);
  if (run.succeeded()) return;
  fmt::print(stderr, "{}{}", run.output, run.errors);
  throw MachineError("the build failed; its output is above");
}

/// Brings this program and what the command needs up to date; starts over if this program has
/// changed.
void bring_up_to_date(const Layout& layout, std::vector<std::string> targets, char** argv) {
  const bool is_built = std::getenv("MC_NO_BUILD") != nullptr;  // by tests and cluster tasks
  if (is_built || layout.judge_is_compiled) return;
  const fs::path program = layout.bin / "lab";
  const auto before = fs::last_write_time(program);
  targets.emplace_back("lab");
  build(layout, targets);
  if (fs::last_write_time(program) == before) return;
  std::vector<std::string> again{program.string()};
  for (char** word = argv + 1; *word != nullptr; ++word) again.emplace_back(*word);
  execute(std::move(again));
}

/// Throws MachineError if files in the build directory are another user's: one run as root leaves
/// such.
void require_own_files(const Layout& layout) {
  for (const fs::path& place : {layout.build, layout.build / "programs"}) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(place, none)) {
      struct stat found {};
      if (lstat(entry.path().c_str(), &found) != 0 || found.st_uid == geteuid()) continue;
      if (!S_ISDIR(found.st_mode) || access(entry.path().c_str(), W_OK) == 0) continue;
      throw MachineError(fmt::format(
          "{} belongs to {}, after a run as another user: remove {}, or sudo chown -R {} {}",
          entry.path().string(), found.st_uid == 0 ? "root" : fmt::format("user {}", found.st_uid),
          layout.build.string(), geteuid(), layout.build.string()));
    }
  }
}

int dispatch(char** argv) {
  std::vector<std::string> words;
  for (char** word = argv + 1; *word != nullptr; ++word) words.emplace_back(*word);
  const Context context = [] {
    Layout layout = read_layout();
    std::vector<Lab> labs = find_labs(layout);
    return Context{std::move(layout), std::move(labs)};
  }();
  require_own_files(context.layout);
  const std::string name = words.empty() ? "" : words[0];
  if (!words.empty()) words.erase(words.begin());
  if (!words.empty() && words[0] == "-h") words[0] = "--help";
  std::optional<Command> command;
  Arguments arguments;
  std::exception_ptr refusal;  // a new version of this program may know the word
  std::vector<std::string> targets;
  const bool is_overview = name == "--help" || name == "-h" || name == "help";
  if (!is_overview && name != "--version") {
    try {
      command = find_command(context, name);
      arguments = command->parse(words);
      if (command->targets != nullptr && !arguments.has("help")) {
        targets = command->targets(context, arguments);
      }
    } catch (const UsageError&) {
      refusal = std::current_exception();
    }
  }
  bring_up_to_date(context.layout, std::move(targets), argv);
  if (refusal) std::rethrow_exception(refusal);
  if (is_overview) {
    print_overview(context.layout);
    return 0;
  }
  if (!command) {
    fmt::print("Monte Carlo labs {}\n", context.layout.version);
    return 0;
  }
  if (arguments.has("help")) {
    print_help(*command);
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

const std::vector<Command>& all_commands() {
  std::ranges::sort(registry(), {},
                    [](const Command& one) { return std::tuple(one.for_instructors, one.name); });
  return registry();
}

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

void execute(std::vector<std::string> command) {
  std::vector<char*> pointers;
  for (std::string& word : command) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  std::fflush(nullptr);
  execvp(pointers[0], pointers.data());
  throw MachineError(fmt::format("cannot run {}", command[0]));
}

std::vector<std::string> targets_of_all(const Context& context, const std::string& prefix) {
  std::vector<std::string> targets;
  for (const Lab& lab : context.labs) targets.push_back(prefix + lab.name);
  return targets;
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
