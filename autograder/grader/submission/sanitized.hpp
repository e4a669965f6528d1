#pragma once
// A lab's program for debugging: run by hand, never judged.

#include <filesystem>
#include <string>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

struct SanitizedProgram {
  std::filesystem::path path;
  std::string failure;  ///< the compiler's or the linker's messages if there is no program
};

/// Compiles the submission's files, the lab's experiments and the runner with debug information and
/// the address and undefined-behavior sanitizers, and links them into build/sanitize/<lab>/. Reuses
/// objects whose sources and headers have not changed.
SanitizedProgram build_sanitized(const Layout& layout, const Lab& lab,
                                 const Submission& submission);

}  // namespace mc::grader
