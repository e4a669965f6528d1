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
//                                    fails exactly those checks (others may wait for them), with
//                                    MC_SEEDS seeds (1)
//   …/attacks/x/name.cpp             // attack: what it tries
//                                    // earns: the points at most, 0 if nothing is said
//                                    // says: words that must stand in the story of some check
//                                    // never says: words that must stand nowhere in it
//                                    whatever is shown is mc::sandbox::printable and in lines that fit
//   …/peers/library/x.cpp            // peer: what of the library it is
//                                    // fails: as "caught by"; of one reason, one after the other
//                                    // because: why the library does not do what the lab asks for
//                                    fails exactly those checks; what the library has nothing for
//                                    is not written. Exit status 77 where it is not installed.
//
// `prove repository` looks at the repository itself: task numbers, points, names.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <set>

#include <fmt/format.h>

#include "checks/support/distributions.hpp"
#include "grader/context/text_file.hpp"
#include "grader/judging/judge.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/compile.hpp"
#include "grader/submission/submission.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

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

  LabVerdict judge(std::uint64_t seed, bool skip_slow = false) const {
    JudgeOptions options;
    options.seed = seed;
    options.skip_slow = skip_slow;
    options.workers = 1;  // ctest runs as many of us as there are cores
    options.submission = submission.label;
    return judge_lab(layout, lab, built, options);
  }
  std::string report(const LabVerdict& verdict, std::uint64_t seed) const {
    Verdict whole;
    whole.submission = submission.label;
    whole.seed = seed;
    return report_lab(verdict, whole, Terminal{});
  }
  void show(const LabVerdict& verdict, std::uint64_t seed) const {
    fmt::print("{}", report(verdict, seed));
  }
};

/// What the random checks of a lab say of themselves, run after run of a right answer.
class PValues {
 public:
  /// One run: may it fail a right answer more than once in a million?
  void add(const LabVerdict& verdict) {
    double alphas = 0;
    for (const CheckResult& result : verdict.checks) {
      for (const mc::protocol::PValue& value : result.p_values) {
        alphas += value.alpha;
        of_null_[value.null].push_back(value.p);
        all_.push_back(value.p);
      }
    }
    most_ = std::max(most_, alphas);
  }

  /// All runs: their p-values are uniform, together and test by test.
  void conclude() const {
    if (all_.empty()) return;
    if (most_ >= 1e-6) complain(fmt::format("its alphas add up to {:.2g}: 1e-6 or more", most_));
    double least = 1;
    for (const auto& [null, values] : of_null_) {
      const double p = uniformity(values);
      if (p < least) least = p;
      if (p < 1e-6 / static_cast<double>(of_null_.size())) {
        complain(fmt::format("p-values that are not uniform (p = {:.2g}): {}", p, null));
      }
    }
    const double together = uniformity(all_);
    if (together < 1e-6) complain(fmt::format("p-values are not uniform (p = {:.2g})", together));
    fmt::print(
        "{} p-values of {} tests, alphas of one run {:.2g} in all; smallest {:.2g}; uniform "
        "together with p = {:.2g}, test by test with {:.2g} at least\n",
        all_.size(), of_null_.size(), most_, *std::min_element(all_.begin(), all_.end()), together,
        least);
  }

 private:
  /// p-value of Kolmogorov and Smirnov's test that `p` is uniform.
  static double uniformity(std::vector<double> p) {
    std::sort(p.begin(), p.end());
    const auto n = static_cast<double>(p.size());
    double distance = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const double below = static_cast<double>(i) / n;
      distance = std::max({distance, p[i] - below, below + 1 / n - p[i]});
    }
    return mc::checks::kolmogorov_tails(distance, p.size()).upper;
  }

  double most_ = 0;
  std::map<std::string, std::vector<double>> of_null_;
  std::vector<double> all_;
};

/// Seeds that went well, with their p-values, kept in the build directory: a thousand seeds take
/// hours, and what interrupts them should not cost what is done. Another program, or other checks,
/// begin anew.
class Progress {
 public:
  explicit Progress(const Proof& proof)
      : file_(proof.layout.build / "proved" /
              fmt::format("{}-{:016x}", fs::path(proof.built.program->path).stem().string(),
                          hash_text(read_text(proof.layout.checks(proof.lab.name))))) {
    fs::create_directories(file_.parent_path());
  }

  /// The first seed that is still to be judged.
  std::uint64_t resume(PValues& p_values) const {
    std::uint64_t next = 1;
    LabVerdict verdict;
    verdict.checks.resize(1);
    std::ifstream file(file_);
    for (std::string line; std::getline(file, line);) {
      char* rest = nullptr;
      mc::protocol::PValue value;
      value.p = std::strtod(line.c_str(), &rest);
      value.alpha = std::strtod(rest, &rest);
      if (line == "seed done") {
        p_values.add(verdict);
        verdict.checks[0].p_values.clear();
        ++next;
      } else {
        value.null = rest;
        verdict.checks[0].p_values.push_back(value);
      }
    }
    return next;
  }

  void keep(const LabVerdict& verdict) const {
    std::string lines;
    for (const CheckResult& result : verdict.checks) {
      for (const mc::protocol::PValue& value : result.p_values) {
        lines += fmt::format("{} {}{}\n", value.p, value.alpha, value.null);
      }
    }
    std::ofstream(file_, std::ios::app) << lines << "seed done\n";
  }

 private:
  fs::path file_;
};

void prove_right(const Proof& proof) {
  const char* wanted = std::getenv("MC_SEEDS");
  const std::uint64_t seeds = wanted == nullptr ? 10 : std::strtoull(wanted, nullptr, 10);
  PValues p_values;
  const Progress progress(proof);
  std::uint64_t seed = wanted == nullptr ? 1 : progress.resume(p_values);
  for (; seed <= seeds; ++seed) {
    const LabVerdict verdict = proof.judge(seed, seed > 1);  // those depend on no seed
    if (wanted != nullptr && verdict.earned() == verdict.points()) progress.keep(verdict);
    p_values.add(verdict);
    if (verdict.earned() == verdict.points()) continue;
    proof.show(verdict, seed);
    complain(fmt::format("seed {}: a right answer without full marks", seed));
    return;
  }
  fmt::print("full marks with {} seeds\n", seeds);
  p_values.conclude();
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

/// The checks that have these names, or beginnings of names.
std::set<std::string> checks_named(const LabVerdict& verdict,
                                   const std::vector<std::string>& starts) {
  std::set<std::string> names;
  for (const std::string& start : starts) {
    std::vector<std::string> found;
    for (const CheckResult& result : verdict.checks) {
      if (result.check.name.starts_with(start)) found.push_back(result.check.name);
    }
    if (found.size() == 1) {
      names.insert(found[0]);
    } else {
      complain(fmt::format("'{}' begins the names of {} checks", start, found.size()));
    }
  }
  return names;
}

/// Those checks failed, and no others; others may wait for them, or be unwritten. Gives the stories
/// of what failed.
std::string compare_failures(const LabVerdict& verdict, const std::set<std::string>& expected,
                             bool may_be_unwritten) {
  std::string stories;
  for (const CheckResult& result : verdict.checks) {
    const bool excused = result.status == Status::passed || result.status == Status::waiting ||
                         result.status == Status::withheld ||
                         (may_be_unwritten && result.status == Status::not_written);
    const bool is_expected = expected.contains(result.check.name);
    if (!excused && result.status != Status::failed) {
      complain(fmt::format("'{}' is {}", result.check.name, describe(result, verdict)));
    }
    if (!excused) stories += result.story + '\n';
    if (!excused && !is_expected) {
      complain(fmt::format("caught by a check it does not name: {}", result.check.name));
    }
    if (excused && is_expected) {
      complain(fmt::format("not caught by: {} ({})", result.check.name, describe(result, verdict)));
    }
  }
  return stories;
}

void prove_mistake(const Proof& proof, const fs::path& file) {
  const char* wanted = std::getenv("MC_SEEDS");
  const std::uint64_t seeds = wanted == nullptr ? 1 : std::strtoull(wanted, nullptr, 10);
  const auto named = said(file, "caught by"), hints = said(file, "hint");
  if (named.empty() || hints.empty()) complain("the file must say 'caught by:' and 'hint:'");
  for (std::uint64_t seed = 1; seed <= seeds && complaints == 0; ++seed) {
    const LabVerdict verdict = proof.judge(seed);
    const std::string stories = compare_failures(verdict, checks_named(verdict, named), false);
    for (const std::string& hint : hints) {
      if (stories.find(hint) == std::string::npos) complain("no story says: " + hint);
    }
    if (seed == 1 || complaints > 0) proof.show(verdict, seed);
  }
}

/// Of a library nobody expects that it does what a lab asks for; but where it does not, that is
/// known, and why.
void prove_peer(const Proof& proof, const fs::path& file) {
  const std::uint64_t seed = 1;
  const LabVerdict verdict = proof.judge(seed);
  if (said(file, "peer").empty()) complain("the file must say 'peer:'");
  if (said(file, "fails").empty() != said(file, "because").empty()) {
    complain("the file must say 'because:' where it says 'fails:'");
  }
  compare_failures(verdict, checks_named(verdict, said(file, "fails")), true);
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
  for (const std::string& word : said(file, "never says")) {
    if (stories.find(word) != std::string::npos) complain("a story says: " + word);
  }
  if (mc::sandbox::printable(stories) != stories) complain("what it is told is not printable");
  for (const std::string_view line : mc::text::split(proof.report(verdict, seed), '\n')) {
    constexpr std::size_t longest = 420;  // a compiler's line, cut
    if (line.size() > longest) complain(fmt::format("too long a line: {}", line.substr(0, 80)));
  }
  proof.show(verdict, seed);
}

// The repository ----------------------------------------------------------------------------------

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
    std::map<std::string, int> mains;
    double points = 0;
    for (const Check& check : checks) {
      tasks.insert(check.task);
      mains[check.task] += check.is_main;
      points += check.points;
      // Catch2 gives these a meaning of their own in a name that is asked for.
      if (check.name.find_first_of(",[]*\\\"~") != std::string::npos) {
        complain(fmt::format("'{}': no , [ ] * \\ \" ~ in a check's name", check.name));
      }
      if (check.points <= 0) complain(fmt::format("'{}' has no points", check.name));
    }
    for (const auto& [task, count] : mains) {
      if (count != 1) complain(fmt::format("task {} has {} checks tagged [main]", task, count));
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
  const bool by_stem = of_course || kind == "peers";
  proof.lab = find_lab(proof.labs, by_stem ? file.stem().string() : top);
  if (kind == "peers") {
    const auto peer = peer_submission(proof.layout, proof.labs, proof.lab, top);
    if (!peer) {
      fmt::print("{} is not installed\n", top);
      std::exit(77);  // skipped, for CTest
    }
    proof.submission = *peer;
  } else {
    proof.submission = single_file_submission(proof.layout, proof.labs, proof.lab, file,
                                              kind != "attacks" && kind != "starter");
  }
  precompile_headers(proof.layout);
  proof.submission.label = path.string();
  proof.built = build_program(proof.layout, proof.lab, proof.submission);
  if (!proof.built.program && kind != "attacks") return complain(proof.built.failure);

  const std::pair<const char*, std::function<void()>> kinds[] = {{"starter", [&] { prove_starter(proof); }},
                                                                 {"solutions", [&] { prove_right(proof); }},
                                                                 {"alternatives", [&] { prove_right(proof); }},
                                                                 {"mistakes", [&] { prove_mistake(proof, file); }},
                                                                 {"peers", [&] { prove_peer(proof, file); }},
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
