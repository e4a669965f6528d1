#pragma once
// Builds a submission's program.

#include <optional>
#include <string>

#include "judge/base/side_by_side.hpp"
#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/submission/submission.hpp"
#include "sandbox/jail.hpp"

namespace mc::grader {

struct BuildResult {
  std::optional<sandbox::Program> program;
  std::string failure;     ///< if there is no program: why, for the student, in a few lines
  double cpu_seconds = 0;  ///< of the compilers and the linker
};

/// Compiles what is new (one translation unit per file) and links. Other builds, of this process or
/// of others, may run at the same time. There is one program: what is timed is what was judged, so
/// that no text can distinguish the two. The library's assertions are on in it; in a loop over a
/// list's own size they cost nothing. Throws MachineError if the machine fails: that is not a
/// grade. `workers` files are compiled at the same time.
BuildResult build_program(const Layout& layout, const Lab& lab, const Submission& submission,
                          unsigned workers = cores());

}  // namespace mc::grader
