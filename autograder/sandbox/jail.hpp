#pragma once
// Runs a submission's program for one measurement, without trusting it.

#include <cstddef>
#include <string>
#include <string_view>

#include "runner/wire.hpp"
#include "sandbox/descriptor.hpp"

namespace mc::sandbox {

/// The limits of one measurement.
struct Limits {
  double cpu_seconds = 2;  ///< rounded up to whole seconds, as the kernel counts them
  /// Far above the CPU time: a program that uses it up without that was delayed by the machine.
  double wall_seconds = 60;
  std::size_t memory = std::size_t{512} << 20;  ///< address space, in bytes
  std::size_t printed = std::size_t{64} << 10;  ///< on standard output and error together
};

/// How a program ended without an answer.
enum class End { over_limit, crashed, other };

/// How a measurement ended.
struct Outcome {
  bool answered = false;                      ///< a complete response came; else see `failure`
  wire::Status status = wire::Status::value;  ///< when answered: a value, or which exception
  std::string bytes;     ///< when answered: the result, or the exception's text, as one short line
  std::string failure;   ///< when not: one line, "called exit(3) instead of returning"
  End end = End::other;  ///< when not
  bool over_limit() const { return !answered && end == End::over_limit; }
  std::string printed;     ///< what it wrote to standard output and standard error, made printable
  double cpu_seconds = 0;  ///< as the kernel counted it, from start to end
  std::size_t peak_memory = 0;  ///< resident, in bytes; of the judge's own at least
};

/// An open program on disk (O_PATH where available), so that what was built is judged even if
/// another file is renamed over it.
struct Program {
  Descriptor descriptor;
  std::string path;
};
Program open_program(const std::string& path);  ///< throws std::system_error

/// Starts the program in the jail, gives it `request`, and waits for its end. docs/security.md
/// describes the jail. Throws std::system_error if the machine fails, or is too busy to run it
/// within its wall time, never for anything that the program does.
Outcome run_jailed(const Program& program, std::string_view request, const Limits& limits = {});

/// The same for a program that another process has opened; the caller keeps `descriptor`.
Outcome run_jailed(int descriptor, const std::string& path, std::string_view request,
                   const Limits& limits = {});

/// The text of an exception from a program, as one short printable line: 16 MB would bury the
/// check's report, and lines could pass for ours.
std::string exception_text(std::string_view text);

/// Is the jail complete? False if the kernel or the build has no seccomp: a grade must then say so.
bool jail_is_complete();

}  // namespace mc::sandbox
