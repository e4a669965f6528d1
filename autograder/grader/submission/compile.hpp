#pragma once
// One file of a submission, compiled. Compiling a stranger's text is already dangerous: it can
// include what it should not see, print it in an error message, or never end. See docs/security.md.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/context/labs.hpp"
#include "grader/context/layout.hpp"
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
};

/// Compiles it, unless that was done before. Throws MachineError where the machine fails.
Object compile(const Unit& unit);

/// Compiles the standard headers, once, so that a file takes half of the time from then on. It
/// takes as long as a file itself: on the way to the very first verdict it would be lost. GCC only.
void precompile_headers(const Layout& layout);

/// The flags of a submission's compilation, as they are recorded with a grade.
std::vector<std::string> compile_flags();

/// What compiler and linker may use.
sandbox::ProcessOptions compiler_limits(const std::filesystem::path& directory);

/// What stopped a compiler or linker before its own end, by its signal and by what it used; empty
/// where nothing did. Its words do not count: they can be a stranger's.
std::string stopped(const sandbox::ProcessResult& run, const sandbox::ProcessOptions& limits);

/// Throws MachineError where the machine, not the text, is why a compilation failed: the same
/// compiler then fails on a text that is known to be right, or the disk is full.
void require_sound_machine(const Layout& layout);

/// Where what is built of a file is kept.
std::filesystem::path slot_of(const Unit& unit);

/// Is there such a file from an earlier build? Then it stays for another hour.
bool is_kept(const std::filesystem::path& file);

}  // namespace mc::grader
