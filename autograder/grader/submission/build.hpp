#pragma once
// From a submission to a program. Compiling a stranger's text is already dangerous: it can include
// what it should not see, print it in an error message, or never end. See docs/security.md.

#include <optional>
#include <string>

#include "grader/context/labs.hpp"
#include "grader/context/layout.hpp"
#include "grader/submission/submission.hpp"
#include "sandbox/jail.hpp"

namespace mc::grader {

/// For judging, the library's assertions are on; for speed they are off.
enum class Variant { judged, speed };

struct Built {
  std::optional<sandbox::Program> program;
  std::string failure;  ///< where there is no program: why, for the student, in a few lines
};

/// Compiles what is new (one translation unit a file) and links. Works beside other builds, of this
/// process or of others.
Built build_program(const Layout& layout, const Lab& lab, const Submission& submission,
                    Variant variant = Variant::judged);

/// The flags of a submission's compilation, as they are recorded with a grade.
std::vector<std::string> compile_flags(Variant variant);

}  // namespace mc::grader
