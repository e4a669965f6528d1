#include "tests/self_test/proof.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/judging/judge.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/compile.hpp"

namespace mc::self_test {

namespace fs = std::filesystem;
using namespace grader;

namespace {

int complaint_count = 0;

/// When the files were written that decide which checks call a function.
std::string times_of_sources(const Proof& proof) {
  std::vector<fs::path> files = proof.layout.objects.at(proof.lab.name);
  files.push_back(proof.layout.checks(proof.lab.name));
  for (const Lab& lab : proof.labs) files.push_back(proof.layout.solutions() / lab.file());
  std::string times = "written:";
  for (const fs::path& file : files) {
    if (!fs::exists(file)) continue;  // another lab may have no solution
    times += fmt::format(" {:x}", fs::last_write_time(file).time_since_epoch().count());
  }
  return times;
}

/// The checks beyond a catalog's task that call this function: those that fail if it aborts. Judged
/// once, whichever mistake asks first, until one of their sources changes.
std::set<std::string> checks_that_call(const std::string& function, const std::string& task,
                                       Proof& proof, const std::vector<Definition>& definitions) {
  const auto beyond = checks_beyond(proof, {task});
  if (beyond.empty()) return {};
  const fs::path kept = proof.layout.build / "affected" / proof.lab.name / task / function;
  const std::string times = times_of_sources(proof);
  std::set<std::string> names;
  std::ifstream file(kept);
  std::string line;
  if (std::getline(file, line) && line == times) {
    while (std::getline(file, line)) names.insert(line);
    return names;
  }
  proof.submission.libraries = linker_flags_to_abort(function, definitions);
  proof.built = build_program(proof.layout, proof.lab, proof.submission);
  if (!proof.built.program) throw MachineError(proof.built.failure);
  for (const CheckResult& result : proof.judge(1, beyond).checks) {
    const bool is_right = result.status == Status::passed || result.status == Status::withheld;
    if (!is_right) names.insert(result.check.name);
  }
  fs::create_directories(kept.parent_path());
  write_text(kept, fmt::format("{}\n{}\n", times, fmt::join(names, "\n")));
  return names;
}

/// A mistake of a catalog: compiles the catalog if that is not done yet, and links it.
void build_mistake(Proof& proof, const Subject& subject) {
  proof.submission.label = "mistakes/" + proof.lab.name + '/' + subject.section;
  const Unit unit{proof.layout, proof.lab, subject.file, true};
  const CatalogLock lock(slot_of(unit));
  const Object catalog = compile(unit);
  if (!catalog.failure.empty()) {
    proof.built.failure = catalog.failure;
    return;
  }
  const auto definitions = definitions_of(proof.layout, proof.lab, catalog.path, subject);
  proof.affected.emplace();
  for (const Definition& one : definitions) {
    if (!one.mistaken.empty()) {
      proof.affected->merge(
          checks_that_call(one.function, subject.file.stem().string(), proof, definitions));
    }
  }
  proof.submission.libraries = linker_flags(definitions);
  proof.built = build_program(proof.layout, proof.lab, proof.submission);
}

}  // namespace

std::set<std::string> checks_beyond(const Proof& proof, const std::set<std::string>& tasks) {
  const auto checks = expected_checks(proof.layout, proof.lab);
  const auto needs_one_of = [](const Check& check, const std::set<std::string>& some) {
    return std::any_of(check.needs.begin(), check.needs.end(),
                       [&](const std::string& need) { return some.contains(need); });
  };
  std::set<std::string> waited_for = tasks;
  for (std::size_t size = 0; size != waited_for.size();) {
    size = waited_for.size();
    for (const Check& check : checks) {
      if (needs_one_of(check, waited_for)) waited_for.insert(check.task);
    }
  }
  std::set<std::string> names;
  for (const Check& check : checks) {
    if (!waited_for.contains(check.task)) names.insert(check.name);
  }
  return names;
}

void complain(const std::string& what) {
  fmt::print("{}\n", what);
  ++complaint_count;
}

int complaints() {
  return complaint_count;
}

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

std::string kind_of(const fs::path& file) {
  std::string top = file.parent_path().filename().string();
  if (top == "starter" || top == "solutions") return top;
  return file.parent_path().parent_path().filename().string();
}

Proof proof_of(const Subject& subject) {
  Proof proof;
  const fs::path& file = subject.file;
  const std::string kind = kind_of(file), top = file.parent_path().filename().string();
  const bool by_stem = kind == top || kind == "peers";
  proof.lab = find_lab(proof.labs, by_stem ? file.stem().string() : top);
  if (kind == "peers") {
    const auto peer = peer_submission(proof.layout, proof.labs, proof.lab, top);
    if (!peer) {
      fmt::print("{} is not installed\n", top);
      std::exit(77);  // skipped, for CTest
    }
    proof.submission = *peer;
  } else {
    const bool is_untrusted = kind == "starter" || kind == "attacks";
    fs::path only = file;
    if (kind == "attacks" && !subject.section.empty()) {
      only = proof.layout.build / "attacks" / subject.section / proof.lab.file();
      fs::create_directories(only.parent_path());
      write_text(only, attack_in(subject, read_text(proof.layout.starter() / proof.lab.file())));
    }
    proof.submission =
        single_file_submission(proof.layout, proof.labs, proof.lab, only, !is_untrusted);
  }
  // The cost of plain answers is measured as on any x86-64.
  if (kind == "alternatives") setenv("MC_BASELINE", "1", 1);
  precompile_headers(proof.layout);
  proof.submission.label = fs::relative(file, proof.layout.root).string();
  if (kind == "attacks" && !subject.section.empty()) {
    proof.submission.label = "attacks/" + proof.lab.name + '/' + subject.section;
  }
  if (kind == "mistakes" && !subject.section.empty()) {
    build_mistake(proof, subject);
  } else {
    proof.built = build_program(proof.layout, proof.lab, proof.submission);
  }
  return proof;
}

grader::LabVerdict Proof::judge(std::uint64_t seed, const std::set<std::string>& checks,
                                unsigned workers) const {
  grader::JudgeOptions options;
  options.seed = seed;
  options.checks = checks;
  options.workers = workers;
  options.submission = submission.label;
  return grader::judge_lab(layout, lab, built, options);
}

std::string Proof::report(const grader::LabVerdict& verdict, std::uint64_t seed) const {
  grader::Verdict whole;
  whole.submission = submission.label;
  whole.seed = seed;
  return grader::report_lab(verdict, whole, grader::Terminal{});
}

void Proof::show(const grader::LabVerdict& verdict, std::uint64_t seed) const {
  fmt::print("{}", report(verdict, seed));
}

}  // namespace mc::self_test
