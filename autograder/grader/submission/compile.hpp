#pragma once
// One file of a submission, compiled. Compiling untrusted text is already dangerous: it can include
// what it should not see, print it in an error message, or never end. See docs/security.md.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/checkout/layout.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {

/// One file of a submission.
struct Unit {
  const Layout& layout;
  const Lab& lab;
  std::filesystem::path file;
  bool trusted;  ///< may include all of the repository
};

struct Object {
  std::filesystem::path path;
  std::string failure;     ///< why there is none, for the student
  double cpu_seconds = 0;  ///< of the compiler; none where it was kept
  std::string key = {};    ///< the whole text that it depends on
};

/// Compiles it, unless that was done before. Throws MachineError where the machine fails.
Object compile(const Unit& unit);

/// Compiles the standard headers, once, so that a file takes half of the time from then on. It
/// takes as long as a file itself: on the way to the very first verdict it would be lost. GCC only.
void precompile_headers(const Layout& layout);

/// The flags of a submission's compilation, as they are recorded with a grade.
std::vector<std::string> compile_flags();

/// How a compiler or linker ended.
struct CompilerRun {
  sandbox::ProcessResult result;
  /// What stopped it before its own end, for the student; empty where nothing did.
  std::string stopped;
};

/// Runs a compiler or linker on untrusted text: within limits, it writes in `directory` only, has no
/// network, no readable input, and a user of its own when the judge is root. Once more where it
/// fails and the text is not at fault. Throws MachineError where the machine fails.
CompilerRun run_compiler(const Layout& layout, const std::vector<std::string>& command,
                         const std::filesystem::path& directory,
                         const std::function<bool(const std::string& errors)>& is_text_at_fault);

/// Throws MachineError where the machine, not the text, is why a compilation failed: the same
/// compiler then fails on a text that is known to be right, or the disk is full.
void require_sound_machine(const Layout& layout);

/// Compiles, links and starts a known program in the sandbox. Throws where the machine cannot.
void probe_machine(const Layout& layout);

/// Where what is built of a file is kept.
std::filesystem::path slot_of(const Unit& unit);

}  // namespace mc::grader
