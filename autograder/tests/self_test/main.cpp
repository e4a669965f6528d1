// Proves one submission of the repository: `self_test FILE`. What must happen to it stands in its first
// lines; what must happen to starters and solutions is known.
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
//                                    whatever is shown is mc::sandbox::printable and in lines that fit
//   …/peers/library/x.cpp            // peer: what of the library it is
//                                    // fails: as "caught by"; of one reason, one after the other
//                                    // because: why the library does not do what the lab asks for
//                                    fails exactly those checks; what the library has nothing for
//                                    is not written. Exit status 77 where it is not installed.
//
// `self_test repository` looks at the repository itself: task numbers, points, names.

#include <cstdlib>
#include <functional>

#include <fmt/format.h>

#include "grader/submission/compile.hpp"
#include "tests/self_test/kept.hpp"
#include "tests/self_test/proof.hpp"

namespace fs = std::filesystem;
using namespace mc::grader;
using namespace mc::self_test;

namespace {

void prove_file(const fs::path& path) {
  Proof proof;
  const fs::path file = fs::canonical(path);
  const std::string top = file.parent_path().filename().string();
  const bool of_course = top == "starter" || top == "solutions";
  const std::string kind = of_course ? top : file.parent_path().parent_path().filename().string();
  const bool by_stem = of_course || kind == "peers";
  proof.lab = find_lab(proof.labs, by_stem ? file.stem().string() : top);
  if (kind == "peers") {
    const auto peer = peer_submission(proof.layout, proof.labs, proof.lab, top);
    if (!peer) {
      fmt::print("{} is not installed\n", top);
      std::exit(77);  // skipped, for CTest
    }
    proof.submission = *peer;
  } else {
    proof.submission = single_file_submission(proof.layout, proof.labs, proof.lab, file,
                                              kind != "attacks" && kind != "starter");
  }
  precompile_headers(proof.layout);
  proof.submission.label = path.string();
  proof.built = build_program(proof.layout, proof.lab, proof.submission);
  if (!proof.built.program && kind != "attacks") return complain(proof.built.failure);

  const std::pair<const char*, std::function<void()>> kinds[] = {{"starter", [&] { prove_starter(proof); }},
                                                                 {"solutions", [&] { prove_right(proof); }},
                                                                 {"alternatives", [&] { prove_right(proof); }},
                                                                 {"mistakes", [&] { prove_mistake(proof, file); }},
                                                                 {"peers", [&] { prove_peer(proof, file); }},
                                                                 {"attacks", [&] { prove_attack(proof, file); }}};
  for (const auto& [name, prove] : kinds) {
    if (kind == name) return prove();
  }
  complain("no such kind of submission: " + kind);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print("usage: self_test FILE | repository | power\n");
    return 2;
  }
  if (std::string_view(argv[1]) == "repository") {
    prove_repository();
  } else if (std::string_view(argv[1]) == "power") {
    print_power();
  } else {
    prove_file(argv[1]);
  }
  return has_complained() ? 1 : 0;
}
