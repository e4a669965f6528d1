#pragma once
// Compiles one file of a submission. Compiling untrusted text is already dangerous: it can include
// what it should not see, print it in an error message, or never end. See docs/security.md.

#include <filesystem>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/submission/step.hpp"

namespace mc::grader {

/// One file of a submission.
struct Unit {
  const Layout& layout;
  const Lab& lab;
  std::filesystem::path file;
  bool trusted;  ///< may include any file
};

struct Object {
  std::filesystem::path path;
  std::string failure;     ///< why there is no object, for the student
  double cpu_seconds = 0;  ///< of the compiler; 0 for a cached object
  std::string key = {};    ///< the full text that it depends on
};

/// Compiles the file unless it is cached, or is known to fail. Throws MachineError if the machine
/// fails.
Object compile(const Unit& unit);

/// Precompiles the standard headers, once, which halves the time of later files. It takes as long
/// as one file, so it must not delay the very first verdict. GCC only.
void precompile_headers(const Layout& layout);

/// The compile flags of a submission, as recorded with a grade.
std::vector<std::string> compile_flags();

/// The flags for the directories of headers, in a stable order: of the labs, and of the repository
/// if wanted.
std::vector<std::string> include_flags(const Layout& layout, bool with_repository);

/// Compiles a text that only includes the lab's header, as `unit` is compiled, to unit.o in
/// `directory`. Throws MachineError if the machine cannot.
void compile_known_text(const Unit& unit, const std::filesystem::path& directory);

/// The directory of everything built from a file.
std::filesystem::path slot_of(const Unit& unit);

}  // namespace mc::grader
