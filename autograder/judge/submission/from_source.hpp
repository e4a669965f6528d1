#pragma once
// What is compiled without CMake: a lab's program to run by hand, and in a handout with a compiled
// judge the objects that all programs of a lab share.

#include <filesystem>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/submission/submission.hpp"

namespace mc::grader {

/// A way to build a program that is run by hand and never judged.
struct BuildKind {
  std::string name;  ///< of its directory in build/
  std::vector<std::string> compile_flags, link_flags;
};

BuildKind for_sanitizers();
BuildKind for_debugger();

struct ProgramByHand {
  std::filesystem::path path;  ///< build/<kind>/<lab>/<directory>/<lab>
  std::string failure;         ///< the compiler's or the linker's messages if there is no program
};

/// Compiles the submission's files, the lab's experiments and the runner, and links them. Reuses
/// objects whose sources and headers have not changed.
ProgramByHand build_by_hand(const Layout& layout, const Lab& lab, const Submission& submission,
                            const BuildKind& kind);

/// The objects of the runner and of the lab's experiments, which are linked to a submission's:
/// CMake's; with a compiled judge, they are compiled here when first needed. Throws
/// MachineError if the compiler fails.
std::vector<std::filesystem::path> shared_objects(const Layout& layout, const Lab& lab);

}  // namespace mc::grader
