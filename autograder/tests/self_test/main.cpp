// Proves the repository's submissions: `self_test FILE [MISTAKE]`. Their comments state the
// expected result (CONTRIBUTING.md, "Add a submission"); proves all mistakes of a catalog, or one.
// Exit status 77 if a peer's library is not installed.
//
//   self_test load RUNS     all that run out of time or memory, under load: the same verdict
//   self_test cost LAB      the cost of measurements of right answers, compiled for any x86-64
//   self_test kills LAB     which check catches which of the lab's mistakes
//   self_test list          all of them, as tests for CTest
//   self_test repository    the repository itself: task numbers, points, names
//   self_test mutants LAB COUNT SEED    small changes to right answers: a check fails each of them

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tests/self_test/proof.hpp"

using namespace mc::self_test;

namespace {

void prove(const Subject& subject) {
  const std::string kind = kind_of(subject.file);
  const std::pair<const char*, void (*)(const Proof&, const Subject&)> kinds[] = {
      {"starter", [](const Proof& proof, const Subject&) { prove_starter(proof); }},
      {"solutions", prove_right},
      {"alternatives", prove_right},
      {"mistakes", prove_mistake},
      {"peers", prove_peer},
      {"attacks", prove_attack}};
  for (const auto& [name, prove_kind] : kinds) {
    if (kind != name) continue;
    const Proof proof = proof_of(subject);
    if (!proof.built.program) {
      if (kind != "attacks") return complain(proof.built.failure);
      return prove_kind(proof, subject);
    }
    const ProofCache passed(proof, subject);
    constexpr const char* thorough[] = {"MC_UNCHANGED_TOO", "MC_SEEDS", "MC_MISTAKE_SEEDS"};
    const bool is_thorough = std::ranges::any_of(
        thorough, [](const char* variable) { return std::getenv(variable) != nullptr; });
    if (!is_thorough && passed.before()) {
      fmt::print("unchanged since it passed\n");
      return;
    }
    const int before = complaints();
    prove_kind(proof, subject);
    const bool is_quick = std::getenv("MC_QUICK") != nullptr;  // fewer seeds
    if (complaints() == before && !is_quick) passed.keep();
    return;
  }
  complain("no such kind of submission: " + kind);
}

/// Prints the submissions as tests for CTest. Long ones start first, and the first of a catalog,
/// which compiles it; --quick has the first of each kind
/// about lab 1, and a mistake of each lab.
void print_list() {
  const Layout layout = read_layout();
  const std::string program = (layout.bin / "self_test").string();
  std::set<std::string> groups;
  const auto print = [&](const fs::path& file, const std::string& name, const Subject& subject,
                         int cost, bool is_quick) {
    fmt::print("add_test([=[{}]=] [=[{}]=] [=[{}]=]{})\n", name, program, file.string(),
               subject.section.empty() ? "" : " " + subject.section);
    fmt::print("set_tests_properties([=[{}]=] PROPERTIES COST {} SKIP_RETURN_CODE 77{})\n", name,
               cost, is_quick ? " LABELS quick" : "");
  };
  for (const fs::path& place : {layout.starter(), layout.solutions(), layout.submissions()}) {
    std::set<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(place)) {
      if (entry.path().extension() == ".cpp") files.insert(entry.path());
    }
    for (const fs::path& file : files) {
      const std::string kind = kind_of(file), folder = file.parent_path().filename().string();
      const std::string lab = kind == folder ? "" : '/' + folder;
      int cost = kind == folder ? 50 : kind == "alternatives" ? 40 : is_catalog(file) ? 11 : 10;
      for (const Subject& subject : subjects_in(file)) {
        const std::string last = subject.section.empty() ? file.stem().string() : subject.section;
        const bool is_mistake = kind == "mistakes";
        const bool is_first = (is_mistake || file.string().find("variance") != std::string::npos) &&
                              groups.insert(is_mistake ? kind + lab : kind).second;
        print(file, kind + lab + '/' + last, subject, cost, is_first);
        if (is_catalog(file)) cost = 10;
      }
    }
  }
}

int run(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "list") {
    print_list();
  } else if (what == "repository") {
    prove_repository();
  } else if (what == "load" && argc > 2) {
    prove_under_load({argv + 3, argv + argc}, static_cast<unsigned>(std::atoi(argv[2])));
  } else if (what == "cost" && argc == 3) {
    prove_cost(argv[2]);
  } else if (what == "kills" && argc == 3) {
    print_kills(argv[2]);
  } else if (what == "fuzz" && argc == 4) {
    prove_against_lies(argv[2], static_cast<unsigned>(std::atoi(argv[3])));
  } else if (what == "mutants" && argc == 5) {
    prove_by_mutants(argv[2], std::strtoull(argv[3], nullptr, 10),
                     std::strtoull(argv[4], nullptr, 10));
  } else if (argc == 2) {
    for (const Subject& subject : subjects_in(fs::canonical(argv[1]))) prove(subject);
  } else if (argc == 3) {
    prove({fs::canonical(argv[1]), argv[2]});
  } else {
    fmt::print(
        "usage: self_test FILE [MISTAKE] | load RUNS [FILE...] | fuzz LAB COUNT | cost LAB | "
        "kills LAB | repository | mutants LAB COUNT SEED\n");
    return 2;
  }
  return complaints() > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {  // no such file, a machine that fails
    fmt::print("self_test: {}\n", error.what());
    return 3;
  }
}
