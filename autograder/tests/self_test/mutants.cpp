// Mutation testing: compiles and judges small changes to right answers in plain style (the
// alternatives of a lab), one by one; a check should fail each of them. A mutant with the same
// program, byte for byte, is equivalent. equivalent.txt lists others with a reason. Ends with the
// score: the killed fraction of the mutants that are not equivalent.

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <tuple>

#include <fmt/format.h>

#include "common/rng.hpp"
#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/judging/judge.hpp"
#include "grader/submission/compile.hpp"
#include "tests/self_test/mutate.hpp"
#include "tests/self_test/proof.hpp"

namespace mc::self_test {

namespace fs = std::filesystem;
using namespace grader;

namespace {

struct Mutant {
  std::string file;  ///< below autograder/submissions
  Mutation mutation;
};

/// The recorded equivalent mutants: "alternatives/variance/x.cpp: a; => b;", then a tab and the
/// reason.
std::set<std::string> equivalents(const fs::path& path) {
  std::set<std::string> all;
  std::istringstream file(read_text(path));
  for (std::string line; std::getline(file, line);) {
    const auto tab = line.find('\t');
    if (tab != std::string::npos && !line.starts_with('#')) all.insert(line.substr(0, tab));
  }
  return all;
}

/// What `f` returns; a busy machine, where a compiler or a check runs out of time, is asked again.
template <class Function>
auto patiently(Function f) {
  for (int attempt = 1; attempt < 5; ++attempt) {
    try {
      return f();
    } catch (const MachineError&) {
      continue;
    }
  }
  return f();
}

/// Builds a program of this source text, if it compiles.
void build(Proof& proof, const std::string& source) {
  const fs::path file = proof.layout.build / "mutants" / proof.lab.name / proof.lab.file();
  fs::create_directories(file.parent_path());
  write_text(file, source);
  proof.submission = single_file_submission(proof.layout, proof.labs, proof.lab, file, true);
  proof.built = patiently([&] { return build_program(proof.layout, proof.lab, proof.submission); });
}

/// The first check that fails; empty if all pass.
std::string killer_of(const Proof& proof, std::uint64_t seed) {
  JudgeOptions options;
  options.seed = seed;
  options.first = true;
  return patiently([&]() -> std::string {
    for (const CheckResult& result :
         judge_lab(proof.layout, proof.lab, proof.built, options).checks) {
      if (result.status == Status::failed) return result.check.name;
      if (result.status == Status::not_judged || result.status == Status::internal_error) {
        throw MachineError(result.check.name + ": " + result.report);
      }
    }
    return {};
  });
}

}  // namespace

void prove_by_mutants(const std::string& name, std::size_t count, std::uint64_t seed) {
  Proof proof;
  proof.lab = find_lab(proof.labs, name);
  precompile_headers(proof.layout);
  std::map<std::string, std::string> sources, programs;
  std::vector<Mutant> mutants;
  for (const auto& entry :
       fs::directory_iterator(proof.layout.submissions() / "alternatives" / proof.lab.name)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string file = fs::relative(entry.path(), proof.layout.submissions()).string();
    sources[file] = read_text(entry.path());
    for (const Mutation& mutation : mutations_of(sources[file])) {
      mutants.push_back({file, mutation});
    }
  }
  std::sort(mutants.begin(), mutants.end(), [](const Mutant& a, const Mutant& b) {
    return std::tie(a.file, a.mutation.offset, a.mutation.replacement) <
           std::tie(b.file, b.mutation.offset, b.mutation.replacement);
  });
  mc::Rng rng(seed);
  for (std::size_t i = mutants.size(); i > 1; --i) std::swap(mutants[i - 1], mutants[rng() % i]);
  const auto recorded =
      equivalents(proof.layout.root / "autograder" / "tests" / "self_test" / "equivalent.txt");
  std::size_t killed = 0, survived = 0, equivalent = 0, same = 0, broken = 0;
  for (const Mutant& mutant : mutants) {
    if (killed + survived + equivalent >= count) break;
    const std::string& source = sources[mutant.file];
    const std::string words =
        fmt::format("{}: {}", mutant.file, description(source, mutant.mutation));
    if (recorded.contains(words)) {
      ++equivalent;
      continue;
    }
    if (!programs.contains(mutant.file)) {
      build(proof, source);
      if (!proof.built.program) return complain(mutant.file + ": " + proof.built.failure);
      programs[mutant.file] = read_text(proof.built.program->path);
    }
    build(proof, mutated(source, mutant.mutation));
    if (!proof.built.program) {
      ++broken;
    } else if (read_text(proof.built.program->path) == programs[mutant.file]) {
      ++same;
    } else if (const std::string killer = killer_of(proof, seed); killer.empty()) {
      ++survived;
      complain("survived  " + words);
    } else {
      ++killed;
      if (std::getenv("MC_VERBOSE") != nullptr) {
        fmt::print("killed    {}\n          by {}\n", words, killer);
      }
    }
    std::fflush(stdout);
  }
  fmt::print(
      "{}: {} of {} mutants killed, {:.1f} %; recorded as equivalent {}; not counted: {} with the "
      "same program, {} that do not compile; {} mutations in all\n",
      proof.lab.name, killed, killed + survived,
      100.0 * static_cast<double>(killed) /
          static_cast<double>(std::max<std::size_t>(1, killed + survived)),
      equivalent, same, broken, mutants.size());
}

}  // namespace mc::self_test
