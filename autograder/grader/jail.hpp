#pragma once
// Runs a submission's program for one measurement, and trusts nothing it does.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "runner/wire.hpp"

namespace mc::grader {

/// What one measurement may use.
struct Limits {
  double cpu_seconds = 2;  ///< rounded up to whole seconds, as the kernel counts them
  double wall_seconds = 10;
  std::size_t memory = std::size_t{512} << 20;  ///< address space, in bytes
  std::size_t printed = std::size_t{64} << 10;  ///< on standard output and standard error together
};

/// How a measurement ended.
struct Outcome {
  bool answered = false;                      ///< a complete response came; else see `failure`
  wire::Status status = wire::Status::value;  ///< when answered: a value, or which exception
  std::string bytes;    ///< when answered: the result, or the exception's text, as one short line
  std::string failure;  ///< when not: one line, "stopped after 2 s of CPU time"
  bool timed_out = false;
  std::string printed;     ///< what it wrote to standard output and standard error, made printable
  double cpu_seconds = 0;  ///< as the kernel counted it, from start to end
  std::size_t peak_memory = 0;  ///< resident, in bytes; of the judge's own at least
};

/// A program on disk, opened (O_PATH where there is such a thing) so that what is judged is what
/// was built, whatever is renamed over it since.
struct Program {
  int descriptor = -1;
  std::string path;
};
Program open_program(const std::string& path);  ///< throws std::system_error

/// Starts the program in the jail, gives it `request`, and waits for its end. What the jail is
/// stands in docs/security.md. Throws std::system_error where the machine fails, never for anything
/// that the program does.
Outcome run_jailed(const Program& program, std::string_view request, const Limits& limits = {});

/// Is every wall of the jail there? False where the kernel or the build has no seccomp: a grade
/// must then say so.
bool jail_is_complete();

/// `text` with everything that is not printable ASCII or well-formed UTF-8 replaced, so that it can
/// stand in a terminal, in JSON and in XML. What turns the direction of writing goes too: nobody
/// who reads it may see another order than there is.
std::string printable(std::string_view text);

/// The beginning of `text`, `most` bytes of it at most, no UTF-8 sequence cut in two; with " …"
/// where something is missing.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace mc::grader
