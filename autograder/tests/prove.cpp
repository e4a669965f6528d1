// Proves one submission of the repository: `prove FILE`. What must happen to it stands in its first
// lines; what must happen to starters and solutions is known.
//
//   starter/x.cpp                    every task is «not written yet», no point, no crash
//   solutions/x.cpp                  full marks, with MC_SEEDS seeds (10)
//   …/alternatives/x/name.cpp        // alternative: what is different about this right answer
//                                    full marks, with as many seeds
//   …/mistakes/x/name.cpp            // mistake: what is wrong
//                                    // caught by: the name of a check, or a unique beginning of it
//                                    // hint: words that must stand in the story of one of those
//                                    fails exactly those checks (others may wait for them)
//   …/attacks/x/name.cpp             // attack: what it tries
//                                    // earns: the points at most, 0 if nothing is said
//                                    // says: words that must stand in the story of some check
//
// `prove repository` looks at the repository itself: task numbers, points, names.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <set>

#include <fmt/format.h>

#include "grader/build.hpp"
#include "grader/judge.hpp"
#include "grader/report.hpp"
#include "grader/submission.hpp"
#include "grader/text_file.hpp"

namespace fs = std::filesystem;
using namespace mc::grader;

namespace {

int complaints = 0;

void complain(const std::string& what) {
  fmt::print("{}\n", what);
  ++complaints;
}

/// The values of "// key: value" in the comment that a file begins with.
std::vector<std::string> said(const fs::path& path, const std::string& key) {
  std::vector<std::string> values;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line) && line.starts_with("//");) {
    const std::string start = "// " + key + ": ";
    if (line.starts_with(start)) values.push_back(line.substr(start.size()));
  }
  return values;
}

struct Proof {
  Layout layout = read_layout();
  std::vector<Lab> labs = find_labs(layout);
  Lab lab;
  Submission submission;
  Built built;

  LabVerdict judge(std::uint64_t seed) const {
    JudgeOptions options;
    options.seed = seed;
    options.workers = 1;  // ctest runs as many of us as there are cores
    options.submission = submission.label;
    return judge_lab(layout, lab, built, options);
  }
  void show(const LabVerdict& verdict, std::uint64_t seed) const {
    Verdict whole;
    whole.submission = submission.label;
    whole.seed = seed;
    fmt::print("{}", report_lab(verdict, whole, Terminal{}));
  }
};

void prove_right(const Proof& proof) {
  const char* wanted = std::getenv("MC_SEEDS");
  const std::uint64_t seeds = wanted == nullptr ? 10 : std::strtoull(wanted, nullptr, 10);
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const LabVerdict verdict = proof.judge(seed);
    if (verdict.earned() == verdict.points()) continue;
    proof.show(verdict, seed);
    complain(fmt::format("seed {}: a right answer without full marks", seed));
    return;
  }
  fmt::print("full marks with {} seeds\n", seeds);
}

void prove_starter(const Proof& proof) {
  const LabVerdict verdict = proof.judge(1);
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::not_written) {
      complain(fmt::format("'{}' is {}\n{}", result.check.name, describe(result, verdict),
                           result.story));
    }
  }
}

void prove_mistake(const Proof& proof, const fs::path& file) {
  const std::uint64_t seed = 1;
  const LabVerdict verdict = proof.judge(seed);
  const auto named = said(file, "caught by"), hints = said(file, "hint");
  if (named.empty() || hints.empty()) complain("the file must say 'caught by:' and 'hint:'");
  std::set<std::string> expected;
  for (const std::string& start : named) {
    std::vector<std::string> found;
    for (const CheckResult& result : verdict.checks) {
      if (result.check.name.starts_with(start)) found.push_back(result.check.name);
    }
    if (found.size() == 1) {
      expected.insert(found[0]);
    } else {
      complain(fmt::format("'{}' begins the names of {} checks", start, found.size()));
    }
  }
  std::string stories;
  for (const CheckResult& result : verdict.checks) {
    const bool failed = result.status != Status::passed && result.status != Status::waiting;
    if (failed && result.status != Status::failed) {
      complain(fmt::format("'{}' is {}", result.check.name, describe(result, verdict)));
    }
    if (failed) stories += result.story + '\n';
    if (failed && !expected.contains(result.check.name)) {
      complain(fmt::format("caught by a check it does not name: {}", result.check.name));
    }
    if (!failed && expected.contains(result.check.name)) {
      complain(fmt::format("not caught by: {} ({})", result.check.name, describe(result, verdict)));
    }
  }
  for (const std::string& hint : hints) {
    if (stories.find(hint) == std::string::npos) complain("no story says: " + hint);
  }
  proof.show(verdict, seed);
}

void prove_attack(const Proof& proof, const fs::path& file) {
  const std::uint64_t seed = 1;
  const LabVerdict verdict = proof.judge(seed);
  const auto earns = said(file, "earns"), words = said(file, "says");
  const double most = earns.empty() ? 0 : std::strtod(earns[0].c_str(), nullptr);
  if (said(file, "attack").empty() || words.empty())
    complain("the file must say 'attack:' and 'says:'");
  if (verdict.earned() > most) {
    complain(fmt::format("it earned {:g} points; {:g} are the most", verdict.earned(), most));
  }
  std::string stories = verdict.no_program;
  for (const CheckResult& result : verdict.checks) {
    stories += '\n' + result.story + '\n' + result.printed;
    if (result.status == Status::internal_error) {
      complain(fmt::format("it broke the autograder in '{}': {}", result.check.name, result.story));
    }
  }
  for (const std::string& word : words) {
    if (stories.find(word) == std::string::npos) complain("no story says: " + word);
  }
  proof.show(verdict, seed);
}

// The repository
// -----------------------------------------------------------------------------------

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

void prove_repository() {
  const Layout layout = read_layout();
  for (const Lab& lab : find_labs(layout)) {
    const auto checks = expected_checks(layout, lab);
    std::set<std::string> tasks;
    double points = 0;
    for (const Check& check : checks) {
      tasks.insert(check.task);
      points += check.points;
      // Catch2 gives these a meaning of their own in a name that is asked for.
      if (check.name.find_first_of(",[]*\\\"~") != std::string::npos) {
        complain(fmt::format("'{}': no , [ ] * \\ \" ~ in a check's name", check.name));
      }
      if (check.points <= 0) complain(fmt::format("'{}' has no points", check.name));
    }
    if (points != 100) complain(fmt::format("lab {}: {:g} points, not 100", lab.name, points));
    const std::pair<fs::path, std::string> places[] = {
        {layout.labs() / lab.folder / lab.header(), "/// "},
        {layout.labs() / lab.folder / "README.md", "\n### "},
        {layout.starter() / lab.file(), "TODO("},
        {layout.solutions() / lab.file(), "// "}};
    for (const auto& [file, before] : places) {
      const auto here = tasks_in(read_text(file), before, lab.number);
      if (here != tasks) {
        complain(fmt::format("{} has the tasks {}; the checks have {}", file.string(), listed(here),
                             listed(tasks)));
      }
    }
  }
}

void prove_file(const fs::path& path) {
  Proof proof;
  const fs::path file = fs::canonical(path);
  const std::string top = file.parent_path().filename().string();
  const bool of_course = top == "starter" || top == "solutions";
  const std::string kind = of_course ? top : file.parent_path().parent_path().filename().string();
  proof.lab = find_lab(proof.labs, of_course ? file.stem().string() : top);
  proof.submission = single_file_submission(proof.layout, proof.labs, proof.lab, file,
                                            kind != "attacks" && kind != "starter");
  proof.submission.label = path.string();
  proof.built = build_program(proof.layout, proof.lab, proof.submission);
  if (!proof.built.program && kind != "attacks") return complain(proof.built.failure);

  const std::pair<const char*, std::function<void()>> kinds[] = {
      {"starter", [&] { prove_starter(proof); }},
      {"solutions", [&] { prove_right(proof); }},
      {"alternatives", [&] { prove_right(proof); }},
      {"mistakes", [&] { prove_mistake(proof, file); }},
      {"attacks", [&] { prove_attack(proof, file); }}};
  for (const auto& [name, prove] : kinds) {
    if (kind == name) return prove();
  }
  complain("no such kind of submission: " + kind);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print("usage: prove FILE | repository\n");
    return 2;
  }
  if (std::string_view(argv[1]) == "repository") {
    prove_repository();
  } else {
    prove_file(argv[1]);
  }
  return complaints == 0 ? 0 : 1;
}
