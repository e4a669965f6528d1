#pragma once
// Compiles one file of a submission. Compiling untrusted text is already dangerous: it can include
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
  bool trusted;  ///< may include any file of the repository
};

struct Object {
  std::filesystem::path path;
  std::string failure;     ///< why there is no object, for the student
  double cpu_seconds = 0;  ///< of the compiler; 0 for a cached object
  std::string key = {};    ///< the full text that it depends on
};

/// Compiles the file unless it is cached. Throws MachineError if the machine fails.
Object compile(const Unit& unit);

/// Precompiles the standard headers, once, which halves the time of later files. It takes as long
/// as one file, so it must not delay the very first verdict. GCC only.
void precompile_headers(const Layout& layout);

/// The compile flags of a submission, as recorded with a grade.
std::vector<std::string> compile_flags();

/// The flags for the directories of headers, in a stable order: of the labs, and of the repository
/// if wanted.
std::vector<std::string> include_flags(const Layout& layout, bool with_repository);

/// How a compiler or linker ended.
struct CompilerRun {
  sandbox::ProcessResult result;
  /// What stopped it early, for the student; empty if it ended by itself.
  std::string stopped;
};

/// Runs a compiler or linker on untrusted text, within limits: it writes only in `directory`, has
/// no network, no readable input, and a separate user when the judge is root. Retries once if it
/// fails and the text is not at fault. Throws MachineError if the machine fails.
CompilerRun run_compiler(const Layout& layout, const std::vector<std::string>& command,
                         const std::filesystem::path& directory,
                         const std::function<bool(const std::string& errors)>& is_text_at_fault);

/// Throws MachineError if the machine, not the text, made a compilation fail: then the same
/// compiler fails on a text that is known to be right, or the disk is full.
void require_working_machine(const Layout& layout);

/// Compiles, links and starts a known program in the sandbox. Throws if the machine cannot.
void probe_machine(const Layout& layout);

/// The directory of everything built from a file.
std::filesystem::path slot_of(const Unit& unit);

}  // namespace mc::grader
