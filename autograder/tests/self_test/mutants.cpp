// Mutation testing: mutants LAB [COUNT] [SEED]. Compiles and judges small changes to right answers
// in plain style (the alternatives of a lab), one by one; a check should fail each of them. A
// mutant with the same program, byte for byte, is equivalent. equivalent.txt lists others with a
// reason. Ends with the score: the killed fraction of the mutants that are not equivalent. Exit
// status 1 if one survived.

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "common/rng.hpp"
#include "grader/base/errors.hpp"
#include "grader/judging/judge.hpp"
#include "grader/submission/compile.hpp"
#include "tests/mutants/mutate.hpp"

namespace fs = std::filesystem;
using namespace mc::grader;
using namespace mc::mutants;

namespace {

std::string contents_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

struct Mutant {
  std::string file;  ///< below autograder/submissions
  Mutation mutation;
};

/// The recorded equivalent mutants: "alternatives/variance/x.cpp: a; => b;", then a tab and the
/// reason.
std::map<std::string, std::string> equivalents(const fs::path& path) {
  std::map<std::string, std::string> all;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const auto tab = line.find('\t');
    if (tab != std::string::npos && !line.starts_with('#')) {
      all[line.substr(0, tab)] = line.substr(tab + 1);
    }
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

class MutantBuilder {
 public:
  explicit MutantBuilder(const std::string& name) : lab_(find_lab(labs_, name)) {
    fs::create_directories(directory_ = layout_.build / "mutants" / lab_.name);
    precompile_headers(layout_);
  }

  const Layout& layout() const { return layout_; }
  const Lab& lab() const { return lab_; }

  /// The program of a source text, if it compiles.
  BuildResult build(const std::string& source) const {
    const fs::path file = directory_ / (lab_.name + ".cpp");
    std::ofstream(file, std::ios::binary) << source;
    return patiently([&] {
      return build_program(layout_, lab_, single_file_submission(layout_, labs_, lab_, file, true));
    });
  }

  /// The first check that fails; empty if all pass.
  std::string killer_of(const BuildResult& built, std::uint64_t seed) const {
    JudgeOptions options;
    options.seed = seed;
    options.first = true;
    return patiently([&]() -> std::string {
      for (const CheckResult& result : judge_lab(layout_, lab_, built, options).checks) {
        if (result.status == Status::failed) return result.check.name;
        if (result.status == Status::not_judged || result.status == Status::internal_error) {
          throw MachineError(result.check.name + ": " + result.report);
        }
      }
      return {};
    });
  }

 private:
  Layout layout_ = read_layout();
  std::vector<Lab> labs_ = find_labs(layout_);
  Lab lab_;
  fs::path directory_;
};

int run(const std::string& name, std::size_t count, std::uint64_t seed) {
  const MutantBuilder laboratory(name);
  const fs::path submissions = laboratory.layout().root / "autograder" / "submissions";
  std::map<std::string, std::string> sources, programs;
  std::vector<Mutant> mutants;
  const fs::path folder = submissions / "alternatives" / laboratory.lab().name;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string file = fs::relative(entry.path(), submissions).string();
    sources[file] = contents_of(entry.path());
    for (const Mutation& mutation : mutations_of(sources[file]))
      mutants.push_back({file, mutation});
  }
  std::sort(mutants.begin(), mutants.end(), [](const Mutant& a, const Mutant& b) {
    return std::tie(a.file, a.mutation.offset, a.mutation.replacement) <
           std::tie(b.file, b.mutation.offset, b.mutation.replacement);
  });
  const std::size_t all = mutants.size();
  mc::Rng rng(seed);
  for (std::size_t i = all; i > 1; --i) std::swap(mutants[i - 1], mutants[rng() % i]);
  const auto recorded =
      equivalents(laboratory.layout().root / "autograder" / "tests" / "mutants" / "equivalent.txt");
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
      const BuildResult right = laboratory.build(source);
      if (!right.program) throw std::runtime_error(mutant.file + ": " + right.failure);
      programs[mutant.file] = contents_of(right.program->path);
    }
    const BuildResult built = laboratory.build(mutated(source, mutant.mutation));
    if (!built.program) {
      ++broken;
    } else if (contents_of(built.program->path) == programs[mutant.file]) {
      ++same;
    } else if (const std::string killer = laboratory.killer_of(built, seed); killer.empty()) {
      ++survived;
      fmt::print("survived  {}\n", words);
    } else {
      ++killed;
      if (std::getenv("MC_VERBOSE") != nullptr)
        fmt::print("killed    {}\n          by {}\n", words, killer);
    }
    std::fflush(stdout);
  }
  fmt::print(
      "{}: {} of {} mutants killed, {:.1f} %; recorded as equivalent {}; not counted: {} with the "
      "same program, {} that do not compile; {} mutations in all\n",
      laboratory.lab().name, killed, killed + survived,
      100.0 * static_cast<double>(killed) /
          static_cast<double>(std::max<std::size_t>(1, killed + survived)),
      equivalent, same, broken, all);
  return survived == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 4) {
    fmt::print("usage: mutants LAB [COUNT] [SEED]\n");
    return 2;
  }
  try {
    const std::size_t count = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 300;
    return run(argv[1], count, argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
  } catch (const std::exception& error) {
    fmt::print("mutants: {}\n", error.what());
    return 3;
  }
}
