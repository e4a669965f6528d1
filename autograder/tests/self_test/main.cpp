// Proves one submission of the repository: `self_test FILE`. What must happen to it stands in its
// first lines; what must happen to starters and solutions is known.
//
//   starter/x.cpp                    every task is «not written yet», no point, no crash
//   solutions/x.cpp                  full marks, with MC_SEEDS seeds (10)
//   …/alternatives/x/name.cpp        // alternative: what is different about this right answer
//                                    full marks, with as many seeds
//   …/mistakes/x/name.cpp            // mistake: what is wrong
//                                    // caught by: the name of a check, or a unique beginning of it
//                                    // hint: words that must stand in the story of one of those
//                                    fails exactly those checks (others may wait for them)
//   …/attacks/x/name.cpp             // attack: what it tries
//                                    // earns: the points at most, 0 if nothing is said
//                                    // says: words that must stand in the story of some check
//                                    // never says: words that must stand nowhere in it
//                                    // forges: a speed task ("3.9 points"): of a right answer that
//                                    cheats when it is timed, and may include solutions/. Then the
//                                    speed line says what `says:` says, and shows no figure.
//                                    whatever is shown is mc::sandbox::printable, in lines that
//                                    fit
//   …/peers/library/x.cpp            // peer: what of the library it is
//                                    // fails: as "caught by"; of one reason, one after the other
//                                    // because: why the library does not do what the lab asks for
//                                    fails exactly those checks; what the library has nothing for
//                                    is not written. Exit status 77 where it is not installed.
//
// Any of the last three says // limit: time, or memory, where a measurement of it meets one;
// `self_test load RUNS` judges all that do beside busy loops, with the same verdict.
//
// `self_test cost LAB` measures what measurements cost the right answers of a lab, compiled as for
// any x86-64. `self_test repository` looks at the repository itself: task numbers, points, names.

#include <cstdlib>
#include <exception>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "tests/self_test/kept.hpp"
#include "tests/self_test/proof.hpp"

namespace fs = std::filesystem;
using namespace mc::grader;
using namespace mc::self_test;

namespace {

void prove_file(const fs::path& path) {
  const std::string kind = kind_of(path);
  const std::pair<const char*, void (*)(const Proof&, const fs::path&)> kinds[] = {
      {"starter", [](const Proof& proof, const fs::path&) { prove_starter(proof); }},
      {"solutions", [](const Proof& proof, const fs::path&) { prove_right(proof); }},
      {"alternatives", [](const Proof& proof, const fs::path&) { prove_right(proof); }},
      {"mistakes", prove_mistake},
      {"peers", prove_peer},
      {"attacks", prove_attack}};
  for (const auto& [name, prove] : kinds) {
    if (kind != name) continue;
    const Proof proof = proof_of(path);
    if (!proof.built.program && kind != "attacks") return complain(proof.built.failure);
    return prove(proof, path);
  }
  complain("no such kind of submission: " + kind);
}

int run(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "repository") {
    prove_repository();
  } else if (what == "power") {
    print_power();
  } else if (what == "load" && argc > 2) {
    prove_under_load({argv + 3, argv + argc}, static_cast<unsigned>(std::atoi(argv[2])));
  } else if (what == "cost" && argc == 3) {
    prove_cost(argv[2]);
  } else if (what == "fuzz" && argc == 4) {
    prove_against_lies(argv[2], static_cast<unsigned>(std::atoi(argv[3])));
  } else if (argc == 2) {
    prove_file(fs::canonical(argv[1]));
  } else {
    fmt::print(
        "usage: self_test FILE | load RUNS [FILE...] | fuzz LAB COUNT | cost LAB | repository | "
        "power\n");
    return 2;
  }
  return has_complained() ? 1 : 0;
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
