#include "grader/verbs/dispatch.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>

#include <fmt/format.h>

#include "grader/context/errors.hpp"
#include "grader/reports/report.hpp"
#include "grader/verbs/list.hpp"
#include "grader/verbs/verb.hpp"

namespace mc::grader {
namespace {

bool is_here(const Layout& layout, const VerbEntry& verb) {
  return std::filesystem::exists(layout.root / verb.about);
}

void print_overview(const Layout& layout) {
  const bool is_handout = !std::filesystem::exists(layout.solutions());
  fmt::print("usage: ./lab VERB ...   (./lab VERB --help says more)\n\n");
  for (const VerbEntry& verb : verb_list) {
    if ((verb.for_instructors && is_handout) || !is_here(layout, verb)) continue;
    fmt::print("  ./lab {:<10} {}\n", verb.name, verb.description);
  }
}

const VerbEntry& find_entry(const std::string& name) {
  std::vector<std::string> names;
  for (const VerbEntry& verb : verb_list) {
    if (verb.name == name) return verb;
    if (!verb.name.empty()) names.emplace_back(verb.name);
  }
  throw UsageError(fmt::format("no verb '{}'; did you mean '{}'? ./lab --help lists them", name,
                               nearest(name, names)));
}

/// The verb, where this program has it.
const Verb* find_verb(std::string_view name) {
  for (const Verb& verb : registered_verbs()) {
    if (verb.name == name) return &verb;
  }
  return nullptr;
}

/// Becomes the program that has all verbs.
[[noreturn]] void run_course(const Layout& layout, char** words) {
  const std::string program = (layout.build / "bin" / course_program).string();
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
  const VerbEntry& entry = find_entry(words.empty() ? "" : words[0]);
  if (!is_here(context.layout, entry)) {
    throw UsageError(
        fmt::format("./lab {} is about {}, which is not here", entry.name, entry.about));
  }
  const Verb* const verb = find_verb(entry.name);
  if (verb == nullptr) run_course(context.layout, argv);
  const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
  if (!rest.empty() && (rest[0] == "--help" || rest[0] == "-h")) {
    fmt::print("usage: ./lab {}\n\n{}.\n{}", verb->usage, entry.description, verb->details);
    return 0;
  }
  const bool wants_json = std::any_of(
      rest.begin(), rest.end(), [](const std::string& word) { return word.starts_with("--json"); });
  if (wants_json && report_json == nullptr) run_course(context.layout, argv);
  const Arguments arguments = parse_arguments(rest, verb->options, verb->words_before_verbatim);
  context.labs = find_labs(context.layout);
  return verb->run(context, arguments);
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
