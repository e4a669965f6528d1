// Starters, mistakes, libraries, attacks: each fails as its comments state.

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/shell.hpp"
#include "judge/judging/judge.hpp"
#include "judge/judging/repeat_commands.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"
#include "sandbox/process.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace {

/// The tasks that a mistake or a library fails: those in "// fails: 5.1, 5.3", and the one that its
/// catalog is named for.
std::set<std::string> failing_tasks(const Subject& subject) {
  std::set<std::string> tasks;
  for (const std::string& name : said(subject, "fails")) {
    tasks.insert(name.substr(0, name.find(' ')));
  }
  if (is_catalog(subject.file)) tasks.insert(subject.file.stem().string());
  return tasks;
}

/// Each of the tasks has a failing check, and no other task does; others may wait for them, or be
/// unwritten. Returns the reports of the failures.
std::string compare_failures(const LabVerdict& verdict, std::set<std::string> tasks,
                             bool may_be_unwritten) {
  std::string reports;
  std::set<std::string> failed;
  for (const CheckResult& result : verdict.checks) {
    const bool excused = result.status == Status::passed || result.status == Status::waiting ||
                         result.status == Status::withheld ||
                         (may_be_unwritten && result.status == Status::not_written);
    if (result.status == Status::failed || result.status == Status::withheld) {
      reports += result.report + '\n';
    }
    if (excused) continue;
    if (result.status != Status::failed) {
      complain(fmt::format("'{}' is {}", result.check.name, describe(result, verdict)));
    }
    if (!tasks.contains(result.check.task)) {
      complain("fails a check of a task that it does not name: " + result.check.name);
    }
    failed.insert(result.check.task);
  }
  for (const std::string& task : tasks) {
    if (!failed.contains(task)) complain("passes all checks of " + task);
  }
  return reports;
}

/// The checks that a mistake in these tasks can fail: those of the tasks, and those of others that
/// do not wait for one of them.
std::set<std::string> checks_to_judge(const Proof& proof, const std::set<std::string>& tasks) {
  std::set<std::string> names;
  for (const std::string& name : checks_beyond(proof, tasks)) {
    if (!proof.affected || proof.affected->contains(name)) names.insert(name);
  }
  for (const Check& check : expected_checks(proof.layout, proof.lab)) {
    if (tasks.contains(check.task)) names.insert(check.name);
  }
  return names;
}

/// With this seed the tasks fail, with the stated hints.
void judge_mistake(const Subject& subject, const LabVerdict& verdict,
                   const std::set<std::string>& tasks) {
  const std::string reports = compare_failures(verdict, tasks, false);
  for (const std::string& hint : said(subject, "hint")) {
    if (reports.find(hint) == std::string::npos) complain("no report says: " + hint);
  }
}

/// The command by hand of each failure runs the program: it is not refused for its arguments.
void run_by_hand(const Proof& proof, const LabVerdict& verdict) {
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::failed || result.call.empty() || !proof.built.program) continue;
    const std::string command = by_hand_command(proof.layout, proof.lab, result.call, {});
    const std::string start = "./lab run " + proof.lab.name + ' ';
    if (!command.starts_with(start)) complain("not a command by hand: " + command);
    const auto run = sandbox::run_process(
        {"sh", "-c", shell_quoted(proof.built.program->path) + ' ' + command.substr(start.size())},
        {.directory = proof.layout.root, .wall_seconds = 2});
    constexpr int refused = 2;
    if (run.exit_code == refused) complain(command + " is refused: " + run.errors);
  }
}

}  // namespace

void prove_starter(const Proof& proof) {
  const LabVerdict verdict = proof.judge(1);
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::not_written) {
      complain(fmt::format("'{}' is {}\n{}", result.check.name, describe(result, verdict),
                           result.report));
    }
  }
}

void prove_mistake(const Proof& proof, const Subject& subject) {
  const std::set<std::string> tasks = failing_tasks(subject);
  if (tasks.empty() || said(subject, "hint").empty()) {
    complain("the file must say which tasks fail ('fails:') and the 'hint:'");
  }
  const int before = complaints();
  const std::uint64_t seeds = number_from("MC_MISTAKE_SEEDS", 1);
  const std::set<std::string> checks = checks_to_judge(proof, tasks);
  std::uint64_t seed = 1;
  LabVerdict verdict = proof.judge(seed, checks);
  judge_mistake(subject, verdict, tasks);
  run_by_hand(proof, verdict);
  compare_limits(subject, verdict);
  while (seed < seeds && complaints() == before) {
    verdict = proof.judge(++seed, checks);
    judge_mistake(subject, verdict, tasks);
  }
  if (complaints() == before) fmt::print("caught with {} seeds\n", seeds);
  proof.show(verdict, seed);
}

/// Which check catches which mistakes of the lab, and which checks catch none that no other does.
void print_kills(const std::string& name) {
  const Layout layout = read_layout();
  const auto labs = find_labs(layout);
  const Lab& lab = find_lab(labs, name);
  std::map<std::string, std::vector<std::string>> caught;  // by check
  std::map<std::string, std::size_t> alone;
  for (const Check& check : expected_checks(layout, lab)) caught[check.name];
  const fs::path place = layout.submissions() / "mistakes" / lab.name;
  for (const auto& file : fs::directory_iterator(place)) {
    if (file.path().extension() != ".cpp") continue;
    for (const Subject& subject : subjects_in(file.path())) {
      const Proof proof = proof_of(subject);
      const auto checks = checks_to_judge(proof, failing_tasks(subject));
      std::vector<std::string> failed;
      for (const CheckResult& result : proof.judge(1, checks).checks) {
        const bool is_wrong = result.status == Status::failed || result.status == Status::waiting;
        if (is_wrong) failed.push_back(result.check.name);
      }
      const std::string mistake =
          subject.section.empty() ? file.path().stem().string() : subject.section;
      for (const std::string& check : failed) caught[check].push_back(mistake);
      if (failed.size() == 1) ++alone[failed[0]];
    }
  }
  for (const auto& [check, mistakes] : caught) {
    fmt::print("{}: {}, {} alone\n    {}\n", check, mistakes.size(), alone[check],
               fmt::join(mistakes, " "));
  }
}

/// A library need not meet a lab's requirements, but deviations must be known, with a reason.
void prove_peer(const Proof& proof, const Subject& subject) {
  const std::uint64_t seed = 1;
  const LabVerdict verdict = proof.judge(seed);
  if (said(subject, "peer").empty()) complain("the file must say 'peer:'");
  if (said(subject, "fails").empty() != said(subject, "because").empty()) {
    complain("the file must say 'because:' where it says 'fails:'");
  }
  compare_failures(verdict, failing_tasks(subject), true);
  compare_limits(subject, verdict);
  proof.show(verdict, seed);
}

void prove_attack(const Proof& proof, const Subject& subject) {
  const std::uint64_t seed = 1;
  const LabVerdict verdict = proof.judge(seed);
  compare_limits(subject, verdict);
  const auto earns = said(subject, "earns"), words = said(subject, "says");
  const double most = earns.empty() ? 0 : std::strtod(earns[0].c_str(), nullptr);
  if (said(subject, "attack").empty() || words.empty())
    complain("the file must say 'attack:' and 'says:'");
  if (verdict.earned() > most) {
    complain(fmt::format("it earned {:g} points; {:g} are the most", verdict.earned(), most));
  }
  std::string reports = verdict.no_program;
  for (const CheckResult& result : verdict.checks) {
    reports += '\n' + result.report + '\n' + result.printed;
    if (result.status == Status::internal_error) {
      complain(
          fmt::format("it broke the autograder in '{}': {}", result.check.name, result.report));
    }
  }
  for (const std::string& word : words) {
    if (reports.find(word) == std::string::npos) complain("no report says: " + word);
  }
  for (const std::string& word : said(subject, "never says")) {
    if (reports.find(word) != std::string::npos) complain("a report says: " + word);
  }
  if (sandbox::printable(reports) != reports) complain("a report is not printable");
  for (const std::string_view line : text::split(proof.report(verdict, seed), '\n')) {
    constexpr std::size_t longest = 420;  // a truncated compiler line
    if (line.size() > longest) complain(fmt::format("too long a line: {}", line.substr(0, 80)));
  }
  proof.show(verdict, seed);
}

}  // namespace mc::self_test
