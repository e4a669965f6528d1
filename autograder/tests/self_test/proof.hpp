#pragma once
// Shared by all proofs of submissions: what files say in comments, judging, complaints.
//
// A catalog is a file of mistakes that is compiled once. Each mistake is a namespace with the
// functions that differ from the solution's; the linker puts them in place. A catalog of attacks is
// not compiled as a whole: each section, with the starter's functions, is its own file.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/judging/verdict.hpp"
#include "judge/submission/build.hpp"
#include "judge/submission/submission.hpp"

namespace mc::self_test {

namespace fs = std::filesystem;
using namespace grader;

/// A submission of the repository: a file, or one mistake or attack of a catalog.
struct Subject {
  fs::path file;
  std::string section = {};  ///< the mistake's namespace, the attack's name; empty for a whole file
};

/// A file that is named for a task, `mistakes/halton/5.1.cpp`, is a catalog.
bool is_catalog(const fs::path& file);

/// The mistakes or attacks of a catalog; of any other file, the file itself.
std::vector<Subject> subjects_in(const fs::path& file);

/// The text of an attack: what its catalog has above the first section, its section, and the
/// starter. If it defines attack(), the starter's first task calls that; else functions of the lab
/// that it defines replace the starter's. An attack that does neither is compiled without starter.
std::string attack_in(const Subject& subject, const std::string& starter);

/// The values of "// key: value" in the comment that a file or an attack begins with, or that is
/// above a mistake. Names of checks are separated by commas.
std::vector<std::string> said(const Subject& subject, const std::string& key);

/// Prints the complaint; the proof has failed.
void complain(const std::string& what);
int complaints();

/// A number from the environment, with which ./lab test sets the thoroughness.
std::uint64_t number_from(const char* variable, std::uint64_t otherwise);

struct Proof {
  Layout layout = read_layout();
  std::vector<Lab> labs = find_labs(layout);
  Lab lab;
  Submission submission;
  BuildResult built;
  /// For a mistake of a catalog: the checks beyond its task that it can affect.
  std::optional<std::set<std::string>> affected{};

  /// All checks, or those with these names. One worker: ctest runs one proof per core.
  LabVerdict judge(std::uint64_t seed, const std::set<std::string>& checks = {},
                   unsigned workers = 1) const;
  std::string report(const LabVerdict& verdict, std::uint64_t seed) const;
  void show(const LabVerdict& verdict, std::uint64_t seed) const;
};

/// Remembers that the proof of a submission passed with the current checks and self-test: it need
/// not be repeated until any of them changes.
class ProofCache {
 public:
  ProofCache(const Proof& proof, const Subject& subject);
  bool before() const { return fs::exists(file_); }
  void keep() const;

 private:
  fs::path file_;
};

/// The checks that neither belong to one of these tasks nor wait for one, directly or not.
std::set<std::string> checks_beyond(const Proof& proof, const std::set<std::string>& tasks);

/// Full marks with every seed, and uniform p-values of its random checks.
void prove_right(const Proof& proof, const Subject& subject);

/// Every task is «not written yet»: no points, no crash.
void prove_starter(const Proof& proof);

/// With every seed, exactly the checks that the file names fail, with the stated hints.
void prove_mistake(const Proof& proof, const Subject& subject);

void prove_peer(const Proof& proof, const Subject& subject);
void prove_attack(const Proof& proof, const Subject& subject);

/// A submission says "// limit: time" (or memory) if and only if a measurement runs out of it.
void compare_limits(const Subject& subject, const LabVerdict& verdict);

/// Which check catches which mistakes of the lab, and how many it alone catches.
void print_kills(const std::string& lab);

/// The verdict on a busy machine equals that on an idle one, for each of these submissions (without
/// any: all that say "// limit:"), `runs` times each with 1, 2 and 4 workers next to four busy
/// loops.
void prove_under_load(std::vector<fs::path> files, unsigned runs);

/// Runs `count` programs that answer with arbitrary numbers and lengths: no check of the lab
/// crashes, and no main check of a task passes unless a right answer would pass.
void prove_against_lies(const std::string& lab, unsigned count);

/// Judges up to `count` mutants of the lab's alternatives (mutants.cpp), and prints the survivors
/// and the score: for use before a release.
void prove_by_mutants(const std::string& lab, std::size_t count, std::uint64_t seed);

/// The kind of a file of the repository, by its folder: "starter", "solutions", "mistakes", …
std::string kind_of(const fs::path& file);

/// A submission of the repository with its program built, ready to prove.
Proof proof_of(const Subject& subject);

/// No measurement of a right answer of the lab takes more than 0.2 s of CPU time, compiled for any
/// x86-64; prints the costliest.
void prove_cost(const std::string& lab);

/// Task numbers, points, names.
void prove_repository();

}  // namespace mc::self_test
