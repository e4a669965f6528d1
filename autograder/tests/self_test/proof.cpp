#include "tests/self_test/proof.hpp"

#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "grader/judging/judge.hpp"
#include "grader/reports/report.hpp"
#include "grader/submission/compile.hpp"

namespace mc::self_test {

using namespace grader;

namespace {

int complaints = 0;

}  // namespace

void complain(const std::string& what) {
  fmt::print("{}\n", what);
  ++complaints;
}

bool has_complained() {
  return complaints > 0;
}

std::vector<std::string> said(const std::filesystem::path& path, const std::string& key) {
  std::vector<std::string> values;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line) && line.starts_with("//");) {
    const std::string start = "// " + key + ": ";
    if (line.starts_with(start)) values.push_back(line.substr(start.size()));
  }
  return values;
}

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

std::string kind_of(const std::filesystem::path& file) {
  const std::string top = file.parent_path().filename().string();
  if (top == "starter" || top == "solutions") return top;
  return file.parent_path().parent_path().filename().string();
}

Proof proof_of(const std::filesystem::path& file) {
  Proof proof;
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
    const bool is_strange =
        kind == "starter" || (kind == "attacks" && said(file, "forges").empty());
    proof.submission =
        single_file_submission(proof.layout, proof.labs, proof.lab, file, !is_strange);
  }
  // What plain answers cost is measured as on any x86-64.
  if (kind == "alternatives") setenv("MC_BASELINE", "1", 1);
  precompile_headers(proof.layout);
  proof.submission.label = std::filesystem::relative(file, proof.layout.root).string();
  proof.built = build_program(proof.layout, proof.lab, proof.submission);
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
