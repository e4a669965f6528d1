// The repository itself: every lab has consistent task numbers, and its points sum to 100.

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

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

/// The lines of all files in a folder that begin with this, without it.
std::vector<std::string> lines_with(const std::string& start, const fs::path& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    std::istringstream lines(read_text(entry.path()));
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(start)) found.push_back(line.substr(start.size()));
    }
  }
  return found;
}

/// A report names a cause ("…"_likely, likely("… {}", x)) only if a recorded mistake has it: its
/// comment quotes the longest part between placeholders, or the text has the whole quote.
void compare_likely(const fs::path& checks, const std::vector<std::string>& quotes) {
  static const std::regex text(R"((likely\(\s*)?((?:"(?:[^"\\\n]|\\.)*"\s*)+)(_likely)?)");
  static const std::regex seams(R"("\s*")"), placeholder(R"(\{[^}]*\})");
  for (const auto& entry : fs::recursive_directory_iterator(checks)) {
    const std::string source = read_text(entry.path());
    for (std::sregex_iterator at(source.begin(), source.end(), text), end; at != end; ++at) {
      if (!(*at)[1].matched && !(*at)[3].matched) continue;
      std::string words = std::regex_replace((*at)[2].str(), seams, "");
      if (words.empty()) continue;  // operator""_likely
      words = words.substr(1, words.rfind('"') - 1);
      std::string longest;
      std::sregex_token_iterator part(words.begin(), words.end(), placeholder, -1), last;
      for (; part != last; ++part) {
        if (part->length() > static_cast<long>(longest.size())) longest = *part;
      }
      const bool is_asserted = std::ranges::any_of(quotes, [&](const std::string& quote) {
        constexpr std::size_t telling = 12;  // characters
        const bool is_whole = longest.size() >= telling && quote.find(longest) != std::string::npos;
        return is_whole || (quote.size() >= telling && words.find(quote) != std::string::npos);
      });
      if (!is_asserted) {
        complain(fmt::format("{}: no mistake has the hint: {}", entry.path().string(), words));
      }
    }
  }
}

}  // namespace

void prove_repository() {
  const Layout layout = read_layout();
  const fs::path submissions = layout.submissions(), judged = layout.root / "autograder" / "checks";
  auto quotes = lines_with("// hint: ", submissions / "mistakes");
  for (std::string& says : lines_with("// says: ", submissions / "attacks")) {
    quotes.push_back(std::move(says));
  }
  compare_likely(judged / "support", quotes);
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
    compare_likely(judged / lab.name, lines_with("// hint: ", submissions / "mistakes" / lab.name));
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
