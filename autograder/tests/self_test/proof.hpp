#pragma once
// Shared by all proofs of submissions: complaints, the statements in a file's comments, judging.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/judging/verdict.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/submission.hpp"
#include "tests/self_test/catalog.hpp"

namespace mc::self_test {

/// Prints the complaint; the proof has failed.
void complain(const std::string& what);
int complaints();

/// A number from the environment, with which ./lab test sets the thoroughness.
std::uint64_t number_from(const char* variable, std::uint64_t otherwise);

struct Proof {
  grader::Layout layout = grader::read_layout();
  std::vector<grader::Lab> labs = grader::find_labs(layout);
  grader::Lab lab;
  grader::Submission submission;
  grader::BuildResult built;
  /// For a mistake of a catalog: the checks beyond its task that it can affect.
  std::optional<std::set<std::string>> affected{};

  /// All checks, or those with these names. One worker: ctest runs one proof per core.
  grader::LabVerdict judge(std::uint64_t seed, const std::set<std::string>& checks = {},
                           unsigned workers = 1) const;
  std::string report(const grader::LabVerdict& verdict, std::uint64_t seed) const;
  void show(const grader::LabVerdict& verdict, std::uint64_t seed) const;
};

/// The checks that neither belong to one of these tasks nor wait for one, directly or not.
std::set<std::string> checks_beyond(const Proof& proof, const std::set<std::string>& tasks);

/// Full marks with every seed, and uniform p-values of its random checks.
void prove_right(const Proof& proof);

/// Every task is «not written yet»: no points, no crash.
void prove_starter(const Proof& proof);

/// With every seed, exactly the checks that the file names fail, with the stated hints.
void prove_mistake(const Proof& proof, const Subject& subject);

void prove_peer(const Proof& proof, const Subject& subject);
void prove_attack(const Proof& proof, const Subject& subject);

/// A submission says "// limit: time" (or memory) if and only if a measurement runs out of it.
void compare_limits(const Subject& subject, const grader::LabVerdict& verdict);

/// The verdict on a busy machine equals that on an idle one, for each of these submissions (without
/// any: all that say "// limit:"), `runs` times each with 1, 2 and 4 workers next to four busy
/// loops.
void prove_under_load(std::vector<std::filesystem::path> files, unsigned runs);

/// Runs `count` programs that answer with arbitrary numbers and lengths: no check of the lab
/// crashes, and no main check of a task passes unless a right answer would pass.
void prove_against_lies(const std::string& lab, unsigned count);

/// Judges up to `count` mutants of the lab's alternatives (mutants.cpp); each survivor is a
/// complaint.
void prove_by_mutants(const std::string& lab, std::size_t count, std::uint64_t seed);

/// The kind of a file of the repository, by its folder: "starter", "solutions", "mistakes", …
std::string kind_of(const std::filesystem::path& file);

/// A submission of the repository with its program built, ready to prove.
Proof proof_of(const Subject& subject);

/// No measurement of a right answer of the lab takes more than 0.2 s of CPU time, compiled for any
/// x86-64; prints the costliest.
void prove_cost(const std::string& lab);

/// Task numbers, points, names.
void prove_repository();

}  // namespace mc::self_test
