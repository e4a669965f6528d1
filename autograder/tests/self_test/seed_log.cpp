#include "tests/self_test/proof.hpp"

#include <algorithm>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "grader/base/text_file.hpp"
#include "protocol/records.hpp"

namespace mc::self_test {
namespace {

constexpr const char* seed_done = "seed done";

fs::path folder(const Layout& layout) {
  return layout.build / "proved";
}

std::vector<std::vector<protocol::PValue>> seeds_in(const fs::path& log) {
  std::vector<std::vector<protocol::PValue>> seeds;
  std::vector<protocol::PValue> p_values;
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) {
    if (line == seed_done) {
      seeds.push_back(std::move(p_values));
      p_values.clear();
    } else if (!line.starts_with('#')) {
      p_values.push_back(protocol::p_value_in(line));
    }
  }
  return seeds;
}

}  // namespace

SeedLog::SeedLog(const Proof& proof) : submission_(proof.submission.label) {
  const std::string checks = read_text(proof.layout.checks(proof.lab.name));
  const std::string program = fs::path(proof.built.program->path).stem().string();
  file_ = folder(proof.layout) / fmt::format("{}-{:016x}", program, hash_text(checks));
  fs::create_directories(file_.parent_path());
}

std::vector<std::vector<protocol::PValue>> SeedLog::seeds() const {
  return seeds_in(file_);
}

void SeedLog::keep(const std::vector<protocol::PValue>& p_values) const {
  std::string lines = fs::exists(file_) ? "" : fmt::format("# {}\n", submission_);
  for (const auto& value : p_values) lines += protocol::text_of(value) + '\n';
  std::ofstream(file_, std::ios::app) << lines << seed_done << '\n';
}

ProofCache::ProofCache(const Proof& proof, const Subject& subject) {
  std::string all = subject.section;
  for (const fs::path& path :
       {fs::path(proof.built.program->path), proof.layout.checks(proof.lab.name), subject.file,
        proof.layout.build / "bin" / "self_test"}) {
    all += read_text(path);
  }
  file_ = folder(proof.layout) / "passed" / fmt::format("{:016x}", hash_text(all));
}

void ProofCache::keep() const {
  fs::create_directories(file_.parent_path());
  std::ofstream{file_};
}

void print_power() {
  const Layout layout = read_layout();
  struct Line {
    std::size_t seeds = 0, tests = 0;
    double alpha = 0, least = 1;
    protocol::PValue nearest{"", 0, 1};  // the rejection closest to alpha, for a mistake
  };
  std::map<std::string, Line> lines;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder(layout), none)) {
    if (!entry.is_regular_file()) continue;
    std::string name;
    std::ifstream log(entry.path());
    std::getline(log, name);  // "# submission"
    name.erase(0, 2);
    Line kept;
    for (const auto& seed : seeds_in(entry.path())) {
      double alpha = 0;
      std::size_t tests = 0;
      for (const protocol::PValue& value : seed) {
        if (value.p <= value.alpha) {
          if (value.p * kept.nearest.alpha > kept.nearest.p * value.alpha) kept.nearest = value;
          continue;
        }
        alpha += value.alpha;
        ++tests;
        kept.least = std::min(kept.least, value.p);
      }
      ++kept.seeds;
      kept.alpha = std::max(kept.alpha, alpha);
      kept.tests = std::max(kept.tests, tests);
    }
    if (Line& old = lines[name]; kept.seeds >= old.seeds) old = kept;
  }
  fmt::print("{:<72}{:>7}{:>8}{:>10}{:>12}{:>11}\n", "submission: always the same fate", "seeds",
             "tests", "alphas", "smallest p", "largest p");
  for (const auto& [name, line] : lines) {
    fmt::print("{:<72}{:>7}{:>8}", name, line.seeds, line.tests);
    if (line.tests > 0) fmt::print("{:>10.2g}{:>12.2g}", line.alpha, line.least);
    if (line.nearest.p > 0) {
      fmt::print("{:>33.0e} of {:.0e}: {}", line.nearest.p, line.nearest.alpha, line.nearest.null);
    }
    fmt::print("\n");
  }
  fmt::print(
      "{} submissions. The largest p is that of the random test that came nearest to passing a\n"
      "mistake, next to its alpha. A test that misses with probability 0.001 shows it in 200 "
      "seeds\n"
      "with 18 %, with probability 0.015 with 95 %\n",
      lines.size());
}

}  // namespace mc::self_test
