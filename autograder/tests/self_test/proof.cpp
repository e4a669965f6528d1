#include "tests/self_test/proof.hpp"

#include <cxxabi.h>
#include <fcntl.h>
#include <sys/file.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/errors.hpp"
#include "judge/base/text_file.hpp"
#include "judge/judging/judge.hpp"
#include "judge/reports/report.hpp"
#include "judge/submission/compile.hpp"
#include "runner/text.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/process.hpp"

namespace mc::self_test {

namespace {

int complaint_count = 0;

/// The functions of namespace mc that objects define or need: mangled names by readable ones.
std::map<std::string, std::string> functions(const std::vector<fs::path>& objects,
                                             const std::string& which) {
  std::vector<std::string> command{"nm", "-P", which};
  for (const fs::path& object : objects) command.push_back(object.string());
  const sandbox::ProcessResult run = sandbox::run_process(command);
  if (!run.succeeded()) throw MachineError("nm: " + run.errors);
  std::map<std::string, std::string> mangled;
  for (const std::string_view line : text::split(run.output, '\n')) {
    const std::string name(line.substr(0, line.find(' ')));
    const std::unique_ptr<char, decltype(&std::free)> readable(
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, nullptr), &std::free);
    if (readable && std::string_view(readable.get()).starts_with("mc::")) {
      mangled[readable.get()] = name;
    }
  }
  return mangled;
}

/// A public function of the lab that a catalog has renamed. All names are mangled.
struct Definition {
  std::string function, right;  ///< the solution's is renamed right_function
  std::string mistaken;         ///< the mistake's; empty if it keeps the right one
};

/// All of them for one mistake. Throws UsageError if it replaces none, or one that is not renamed.
std::vector<Definition> definitions_of(const Layout& layout, const Lab& lab, const fs::path& object,
                                       const Subject& subject) {
  std::vector<fs::path> callers = layout.objects.at(lab.name);
  callers.push_back(object);
  const auto defined = functions({object}, "--defined-only");
  std::vector<Definition> definitions;
  bool differs = false;
  for (const auto& [name, symbol] : functions(callers, "--undefined-only")) {
    const std::string function = name.substr(std::string_view("mc::").size());
    const auto mistaken = defined.find("mc::" + subject.section + "::" + function);
    const auto right = defined.find("mc::right_" + function);
    const bool is_mistaken = mistaken != defined.end();
    if (!is_mistaken && right == defined.end()) continue;
    if (right == defined.end()) throw UsageError(function + " is not renamed");
    differs = differs || is_mistaken;
    definitions.push_back({symbol, right->second, is_mistaken ? mistaken->second : ""});
  }
  if (!differs) throw UsageError(subject.section + " replaces no function of the lab");
  return definitions;
}

/// The linker's flags that put in place of each function what `chosen` names.
template <class Choose>
std::vector<std::string> linker_flags(const std::vector<Definition>& definitions, Choose chosen) {
  std::vector<std::string> flags;
  for (const Definition& one : definitions) {
    flags.push_back(fmt::format("-Wl,--defsym={}={}", one.function, chosen(one)));
  }
  return flags;
}

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
  proof.submission.libraries = linker_flags(definitions, [&](const Definition& one) {
    return one.function == function ? "abort" : one.right;
  });
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
  // One process at a time: the first compiles the catalog, the others wait for it.
  fs::create_directories(slot_of(unit));
  const sandbox::Descriptor lock(
      open((slot_of(unit) / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644),
      "opening the lock");
  flock(lock.get(), LOCK_EX);
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
  proof.submission.libraries = linker_flags(definitions, [](const Definition& one) {
    return one.mistaken.empty() ? one.right : one.mistaken;
  });
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

ProofCache::ProofCache(const Proof& proof, const Subject& subject) {
  std::string all = subject.section;
  for (const fs::path& path :
       {fs::path(proof.built.program->path), proof.layout.checks(proof.lab.name), subject.file,
        proof.layout.build / "bin" / "self_test"}) {
    all += read_text(path);
  }
  file_ = proof.layout.build / "proved" / fmt::format("{:016x}", hash_text(all));
}

void ProofCache::keep() const {
  fs::create_directories(file_.parent_path());
  std::ofstream{file_};
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

LabVerdict Proof::judge(std::uint64_t seed, const std::set<std::string>& checks,
                        unsigned workers) const {
  JudgeOptions options;
  options.seed = seed;
  options.checks = checks;
  options.workers = workers;
  options.submission = submission.label;
  return judge_lab(layout, lab, built, options);
}

std::string Proof::report(const LabVerdict& verdict, std::uint64_t seed) const {
  Verdict whole;
  whole.submission = submission.label;
  whole.seed = seed;
  return report_lab(verdict, whole, Terminal{});
}

void Proof::show(const LabVerdict& verdict, std::uint64_t seed) const {
  fmt::print("{}", report(verdict, seed));
}

}  // namespace mc::self_test
