#include "tests/self_test/proof.hpp"

#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

#include "grader/reports/report.hpp"

namespace mc::self_test {
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

grader::LabVerdict Proof::judge(std::uint64_t seed, const std::set<std::string>& checks) const {
  grader::JudgeOptions options;
  options.seed = seed;
  options.checks = checks;
  options.workers = 1;  // ctest runs as many of us as there are cores
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
