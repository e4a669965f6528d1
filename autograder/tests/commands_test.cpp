// Every command in a document exists: its command, its options, its lab and its task. Cheap ones
// are run.
#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/ranges.h>

#include "commands/command.hpp"
#include "judge/judging/judge.hpp"
#include "runner/text.hpp"
#include "tests/documents.hpp"
#include "tests/submissions.hpp"

namespace mc::tests::commands {

namespace {

/// A command in a document.
struct CommandLine {
  std::string document;
  Words words;
  std::string text() const { return fmt::format("{}: {}", document, fmt::join(words, " ")); }
};

bool is_command(std::string_view text) {
  return text.starts_with("./lab") || text.starts_with(".ci/") || text.starts_with("build/bin/");
}

/// The code in a document: whole lines of blocks, and spans in the text.
struct Code {
  Words lines, spans;
};
Code code_in(const std::string& document) {
  Code code;
  std::string prose;
  bool fenced = false;
  std::istringstream lines(document);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      fenced = !fenced;
    } else if (fenced || line.starts_with("    ")) {
      const auto begin = std::min(line.find_first_not_of(' '), line.size());
      code.lines.emplace_back(line.substr(begin));
    } else {
      prose += line + (line.empty() ? "\n\n" : " ");  // a span may cross a line end
    }
  }
  for (const std::string_view paragraph : text::split(prose, '\n')) {
    const auto parts = text::split(paragraph, '`');
    for (std::size_t i = 1; i + 1 < parts.size(); i += 2) code.spans.emplace_back(parts[i]);
  }
  return code;
}

std::vector<CommandLine> command_lines(const Layout& layout) {
  std::vector<CommandLine> all;
  for (const fs::path& file : documents(layout)) {
    Code code = code_in(without_comments(read_text(file)));
    code.lines.insert(code.lines.end(), code.spans.begin(), code.spans.end());
    for (std::string line : code.lines) {
      for (const std::string_view before : {prompt, std::string_view("parallel ")}) {
        if (line.starts_with(before)) line.erase(0, before.size());
      }
      if (!is_command(line)) continue;
      Words words = words_of(line);
      // "…" means more of the same; what follows a pipe, an & or ::: is not a command of ours.
      std::erase_if(words, [](auto& word) { return word == "…" || word == "..."; });
      const auto end = std::find_if(words.begin(), words.end(), [](auto& word) {
        return word == ":::" || word == "|" || word == "&" || word == "&&" || word.starts_with(">");
      });
      words.erase(end, words.end());
      all.push_back({fs::relative(file, layout.root).string(), words});
    }
  }
  return all;
}

/// Is a word a placeholder: LAB, DIR…, F.zip?
bool is_placeholder(const std::string& word) {
  return !word.empty() && word[0] >= 'A' && word[0] <= 'Z';
}

const std::set<std::string> takes_a_lab{"check", "run", "plot", "submit", "gradescope"};

/// Why this command is invalid; empty if it is valid.
std::string objection(const Layout& layout, const std::vector<Lab>& labs, const Words& words) {
  if (words.size() == 1 || words[1] == "COMMAND" || words[1].starts_with("--")) return {};
  const auto& commands = all_commands();
  const auto command = std::find_if(commands.begin(), commands.end(),
                                    [&](const Command& one) { return one.name == words[1]; });
  if (command == commands.end()) return "no such command";
  try {
    const Words rest(words.begin() + 2, words.end());
    if (!rest.empty() && rest[0] == "--help") return {};
    const Arguments arguments = command->parse(rest);
    if (!takes_a_lab.contains(command->name) || arguments.words.empty()) return {};
    if (is_placeholder(arguments.words[0])) return {};
    const LabAndTask meant = lab_and_task(labs, arguments.words);
    const std::string task = arguments.get("only").value_or(meant.task);
    if (command->name != "check" || task.empty()) return {};
    const auto checks = expected_checks(layout, meant.lab);
    const bool is_there = std::any_of(checks.begin(), checks.end(),
                                      [&](const Check& check) { return check.task == task; });
    return is_there ? "" : "no such task";
  } catch (const UsageError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("every command in a document is valid") {
  const Layout layout = read_layout();
  const auto labs = find_labs(layout);
  std::set<std::string> commands;
  for (const CommandLine& command : command_lines(layout)) {
    CAPTURE(command.text());
    if (command.words[0] == "./lab") {
      CHECK(objection(layout, labs, command.words) == "");
      if (command.words.size() > 1) commands.insert(command.words[1]);
    } else if (command.words[0].starts_with(".ci/")) {
      CHECK(fs::exists(layout.root / command.words[0]));
    } else {
      const std::string target = fs::path(command.words[0]).filename();
      CHECK(fs::exists(layout.build / "CMakeFiles" / (target + ".dir")));
    }
  }
  // Some document mentions each command, and the test detects wrong ones.
  for (const Command& command : all_commands()) {
    if (command.name.empty() || command.name == "setup") continue;
    CAPTURE(command.name);
    CHECK(commands.contains(command.name));
  }
  CHECK(objection(layout, labs, {"./lab", "chekc", "1"}) == "no such command");
  CHECK(contains(objection(layout, labs, {"./lab", "check", "1", "--onyl", "1.1"}), "--onyl"));
  CHECK(objection(layout, labs, {"./lab", "check", "1", "--only", "1.99"}) == "no such task");
  CHECK(contains(objection(layout, labs, {"./lab", "plot", "9"}), "no lab"));
}

TEST_CASE("every option that a document names belongs to a command") {
  const Layout layout = read_layout();
  std::set<std::string> known{"--help", "--version", "--preset",
                              "--build"};  // CMake's, the last two
  for (const Command& command : all_commands()) {
    for (const CommandOption& option : command.options) {
      known.insert(option.shown.substr(0, option.shown.find_first_of(" ,")));
    }
  }
  for (const fs::path& file : documents(layout)) {
    const Code code = code_in(without_comments(read_text(file)));
    for (const std::string& span : code.spans) {
      if (!span.starts_with("--")) continue;
      CAPTURE(file, span);
      CHECK(known.contains(words_of(span)[0].substr(0, span.find('='))));
    }
  }
}

TEST_CASE("the commands that a handout gives run, with the solutions") {
  const Layout layout = read_layout();
  const auto labs = find_labs(layout);
  std::size_t count = 0;
  for (const CommandLine& command : command_lines(layout)) {
    if (command.words.size() < 4 || command.words[1] != "run") continue;
    if (is_placeholder(command.words[2])) continue;
    Words words(command.words.begin() + 1, command.words.end());
    words.insert(words.begin() + 1, {"--dir", layout.solutions().string()});
    CAPTURE(command.text());
    REQUIRE_RUN(run, lab(words));
    CHECK(!run.output.empty());
    ++count;
  }
  CHECK(count >= labs.size());
}

}  // namespace mc::tests::commands
