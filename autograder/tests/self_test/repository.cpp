// The repository itself: every lab has consistent task numbers, and its points sum to 100.

#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "judge/base/text_file.hpp"
#include "judge/checkout/hints.hpp"
#include "judge/judging/judge.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace {

/// The task numbers "N.k" that follow `before` in a text.
std::set<std::string> tasks_in(const std::string& text, const std::string& before, int number) {
  std::set<std::string> tasks;
  const std::string start = before + std::to_string(number) + '.';
  for (auto at = text.find(start); at != std::string::npos; at = text.find(start, at + 1)) {
    std::size_t end = at + start.size();
    while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end]))) ++end;
    if (end > at + start.size()) {
      tasks.insert(text.substr(at + before.size(), end - at - before.size()));
    }
  }
  return tasks;
}

std::string listed(const std::set<std::string>& tasks) {
  std::string all;
  for (const std::string& task : tasks) all += task + ' ';
  return all;
}

/// A text with single blanks in place of line ends and of several.
std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool is_blank = c == ' ' || c == '\n';
    if (!is_blank) {
      line += c;
    } else if (!line.ends_with(' ')) {
      line += ' ';
    }
  }
  return line;
}

/// The questions that the answers quote ("> …") are the handout's.
void compare_questions(const Layout& layout, const Lab& lab) {
  const std::string handout = on_one_line(read_text(layout.labs() / lab.folder / "README.md"));
  const fs::path answers = layout.root / "docs" / "answers" / (lab.folder + ".md");
  std::string quote;
  std::istringstream lines(read_text(answers) + "\n\n");
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("> ")) {
      quote += line.substr(2) + ' ';
    } else if (!quote.empty()) {
      std::string question = on_one_line(quote);
      question.pop_back();
      if (handout.find(question) == std::string::npos) {
        complain(
            fmt::format("{} quotes what the handout does not ask: {}", answers.string(), question));
      }
      quote.clear();
    }
  }
}

}  // namespace

void prove_repository() {
  const Layout layout = read_layout();
  for (const Lab& lab : find_labs(layout)) {
    const auto checks = expected_checks(layout, lab);
    std::set<std::string> tasks;
    std::map<std::string, int> mains;
    double points = 0;
    for (const Check& check : checks) {
      tasks.insert(check.task);
      mains[check.task] += check.is_main;
      points += check.points;
      // Catch2 interprets these characters in a test name on the command line.
      if (check.name.find_first_of(",[]*\\\"~") != std::string::npos) {
        complain(fmt::format("'{}': no , [ ] * \\ \" ~ in a check's name", check.name));
      }
      // 0 is how an instructor leaves a task out.
      if (check.points < 0) complain(fmt::format("'{}' has negative points", check.name));
    }
    for (const auto& [task, count] : mains) {
      if (count != 1) complain(fmt::format("task {} has {} checks tagged [main]", task, count));
    }
    const bool is_changed = fs::exists(layout.root / "points.csv");
    if (points != 100 && !is_changed)
      complain(fmt::format("lab {}: {:g} points, not 100", lab.name, points));
    const std::pair<fs::path, std::string> places[] = {
        {layout.labs() / lab.folder / lab.header(), "/// "},
        {layout.labs() / lab.folder / "README.md", "\n### "},
        {layout.labs() / lab.folder / "hints.md", "\n## "},
        {layout.starter() / lab.file(), "TODO("},
        {layout.solutions() / lab.file(), "// "}};
    compare_questions(layout, lab);
    for (const std::string& task : tasks) {
      const auto hints = hints_for(layout, lab, task);
      if (hints.size() != 3) {
        complain(fmt::format("labs/{}/hints.md has {} steps for {}, not 3", lab.folder,
                             hints.size(), task));
      }
    }
    for (const auto& [file, before] : places) {
      const auto here = tasks_in(read_text(file), before, lab.number);
      if (here != tasks) {
        complain(fmt::format("{} has the tasks {}; the checks have {}", file.string(), listed(here),
                             listed(tasks)));
      }
    }
  }
}

}  // namespace mc::self_test
