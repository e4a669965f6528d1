// Starters, mistakes, libraries, attacks: each fails as it says.

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "grader/judging/judge.hpp"
#include "grader/judging/speed.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"
#include "tests/self_test/kept.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

using grader::CheckResult;
using grader::LabVerdict;
using grader::Status;

namespace {

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

bool begins_with_one_of(const std::string& name, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](const std::string& start) { return name.starts_with(start); });
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

bool fails_more(const LabVerdict& verdict, const std::set<std::string>& expected) {
  return std::any_of(verdict.checks.begin(), verdict.checks.end(), [&](const CheckResult& result) {
    return result.status == Status::failed && !expected.contains(result.check.name);
  });
}

/// With this seed, of these checks, those fail that the file names, and say its hints.
void judge_mistake(const Subject& subject, const LabVerdict& verdict,
                   const std::set<std::string>& named) {
  const std::string stories = compare_failures(verdict, named, false);
  for (const std::string& hint : said(subject, "hint")) {
    if (stories.find(hint) == std::string::npos) complain("no story says: " + hint);
  }
}

/// The checks whose outcome says nothing of a mistake that fails these: each of them needs a task
/// that fails, so it passes or waits, and either is right. Not those of a task that a judged check
/// needs in turn: whether that check waits is to be seen.
std::set<std::string> checks_that_wait(const std::vector<grader::Check>& checks,
                                       const std::vector<std::string>& named) {
  std::set<std::string> at_fault, waiting;
  for (const grader::Check& check : checks) {  // what is an edge case holds nobody up
    if (!check.is_edge && begins_with_one_of(check.name, named)) at_fault.insert(check.task);
  }
  const auto need_one_of = [](const grader::Check& check, const std::set<std::string>& tasks) {
    return std::any_of(check.needs.begin(), check.needs.end(),
                       [&](const std::string& need) { return tasks.contains(need); });
  };
  for (const grader::Check& check : checks) {
    const bool waits = need_one_of(check, at_fault) && !begins_with_one_of(check.name, named);
    if (waits) waiting.insert(check.name);
  }
  for (bool changed = true; changed;) {
    std::set<std::string> needed;
    for (const grader::Check& check : checks) {
      if (!waiting.contains(check.name)) needed.insert(check.needs.begin(), check.needs.end());
    }
    changed = false;
    for (const grader::Check& check : checks) {
      const bool is_needed = !check.is_edge && needed.contains(check.task);
      if (is_needed && waiting.erase(check.name) > 0) changed = true;
    }
  }
  return waiting;
}

/// Of each failed check the test that ended it, if it was a random one; `null` names the check.
std::vector<protocol::PValue> rejections(const LabVerdict& verdict) {
  std::vector<protocol::PValue> found;
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::failed || result.p_values.empty()) continue;
    const protocol::PValue& last = result.p_values.back();
    if (last.p <= last.alpha) found.push_back({result.check.name, last.p, last.alpha});
  }
  return found;
}

}  // namespace

void prove_starter(const Proof& proof) {
  const LabVerdict verdict = proof.judge(1);
  for (const CheckResult& result : verdict.checks) {
    if (result.status != Status::not_written) {
      complain(fmt::format("'{}' is {}\n{}", result.check.name, describe(result, verdict),
                           result.story));
    }
  }
}

void prove_mistake(const Proof& proof, const Subject& subject) {
  if (said(subject, "caught by").empty() || said(subject, "hint").empty()) {
    complain("the file must say 'caught by:' and 'hint:'");
  }
  const int before = complaints();
  const std::uint64_t seeds = number_from("MC_MISTAKE_SEEDS", 1);
  // A slow check takes longer than all others together: of those that a mistake does not name it is
  // asked in --full only, and once, for it does not depend on the seed. With more seeds: the tasks
  // at fault. To the others this is a right answer, and of those prove_right asks more; but where
  // more fails than is named, it may wait for them, and all are asked. A check that waits for what
  // fails is asked in --full only, too.
  const auto named = said(subject, "caught by");
  std::vector<std::string> tasks;
  for (const std::string& start : named) tasks.push_back(start.substr(0, start.find(' ') + 1));
  const auto checks = grader::expected_checks(proof.layout, proof.lab);
  // A check that waits may be the one that meets the file's limit.
  const bool has_limit = !said(subject, "limit").empty();
  const auto waiting = has_limit ? std::set<std::string>{} : checks_that_wait(checks, named);
  std::set<std::string> once, again, all;
  for (const grader::Check& check : checks) {
    const bool is_named = begins_with_one_of(check.name, named);
    if (!is_named && !proof.affected.empty() && !proof.affected.contains(check.name)) continue;
    const bool tells = !check.is_slow && !waiting.contains(check.name);
    if (tells || is_named || seeds > 1) once.insert(check.name);
    if (check.is_slow) continue;
    all.insert(check.name);
    if (begins_with_one_of(check.name, tasks)) again.insert(check.name);
  }
  const LabVerdict first = proof.judge(1, once);
  auto expected = checks_named(first, named);
  judge_mistake(subject, first, expected);
  std::erase_if(expected, [&](const std::string& name) { return !again.contains(name); });
  compare_limits(subject, first);
  std::uint64_t seed = 2;
  std::optional<Kept> kept;
  if (seeds > 1) seed = std::max(seed, kept.emplace(proof).resume([](const auto&) {}) + 1);
  LabVerdict shown = first;
  std::uint64_t seed_shown = 1;
  for (; seed <= seeds && complaints() == before; ++seed) {
    LabVerdict verdict = proof.judge(seed, again);
    if (fails_more(verdict, expected)) verdict = proof.judge(seed, all);
    judge_mistake(subject, verdict, expected);
    if (complaints() > before) {
      shown = verdict;
      seed_shown = seed;
    } else {
      kept->keep(rejections(verdict));
    }
  }
  if (complaints() == before) fmt::print("the same fate with {} seeds\n", seeds);
  proof.show(shown, seed_shown);
}

/// Of a library nobody expects that it does what a lab asks for; but where it does not, that is
/// known, and why.
void prove_peer(const Proof& proof, const Subject& subject) {
  const std::uint64_t seed = 1;
  const LabVerdict verdict = proof.judge(seed);
  if (said(subject, "peer").empty()) complain("the file must say 'peer:'");
  if (said(subject, "fails").empty() != said(subject, "because").empty()) {
    complain("the file must say 'because:' where it says 'fails:'");
  }
  compare_failures(verdict, checks_named(verdict, said(subject, "fails")), true);
  compare_limits(subject, verdict);
  proof.show(verdict, seed);
}

/// A right answer as long as it is judged, and something faster when it is timed: it may pass every
/// check, but there is no figure for what it forges.
void prove_forgery(const Proof& proof, const Subject& subject) {
  const std::uint64_t seed = 1;
  LabVerdict verdict = proof.judge(seed);
  verdict.speed = grader::measure_speed(proof.layout, verdict, *proof.built.program);
  for (const std::string& forged : said(subject, "forges")) {
    const auto found =
        std::find_if(verdict.speed.begin(), verdict.speed.end(),
                     [&](const grader::Speed& one) { return one.name.starts_with(forged); });
    if (found == verdict.speed.end()) {
      complain("it was not timed, for it fails a check of the task: " + forged);
    } else if (found->wrong.empty()) {
      complain(fmt::format("a forged figure: {} takes {:.3g} ns", found->name, found->nanoseconds));
    } else {
      for (const std::string& word : said(subject, "says")) {
        if (found->wrong.find(word) == std::string::npos) complain("no speed line says: " + word);
      }
    }
  }
  proof.show(verdict, seed);
}

void prove_attack(const Proof& proof, const Subject& subject) {
  if (!said(subject, "forges").empty() && proof.built.program) return prove_forgery(proof, subject);
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
  for (const std::string& word : said(subject, "never says")) {
    if (stories.find(word) != std::string::npos) complain("a story says: " + word);
  }
  if (sandbox::printable(stories) != stories) complain("what it is told is not printable");
  for (const std::string_view line : text::split(proof.report(verdict, seed), '\n')) {
    constexpr std::size_t longest = 420;  // a compiler's line, cut
    if (line.size() > longest) complain(fmt::format("too long a line: {}", line.substr(0, 80)));
  }
  proof.show(verdict, seed);
}

}  // namespace mc::self_test
