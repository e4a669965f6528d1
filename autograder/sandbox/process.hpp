#pragma once
// Runs a trusted program (a compiler, the checks, git, gnuplot) and waits for it. Every external
// program is started here, in an environment that does not depend on who types.

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sandbox/confinement.hpp"

namespace mc::sandbox {

using Environment = std::vector<std::pair<std::string, std::string>>;

/// The environment of every program that run_process() starts: PATH and LD_LIBRARY_PATH of this
/// process without relative places (a toolchain of environment modules needs both), LC_ALL=C,
/// TMPDIR, a HOME that does not exist, CCACHE_DISABLE=1. Nothing else.
Environment fixed_environment();

/// The absolute places in a list such as PATH; those that the variable `name` has in this process.
std::vector<std::string> places_in(const char* name);

struct ProcessOptions {
  std::filesystem::path directory = {};  ///< working directory
  Environment environment = {};          ///< added to the fixed one; the same names are replaced
  /// Our descriptors, and their numbers in the child, below 16. It has no others but 0, 1 and 2.
  std::vector<std::pair<int, int>> descriptors = {};
  double cpu_seconds = 0;  ///< limits, for each process it starts; 0: none
  double wall_seconds = 0;
  std::size_t memory = 0;                     ///< address space
  std::size_t file_size = 0;                  ///< of each file that it writes
  std::size_t output = std::size_t{4} << 20;  ///< bytes of output kept; the rest is discarded
  const std::atomic<bool>* stop = nullptr;    ///< stops it soon after this becomes true
  const Places* places = nullptr;             ///< confines it to these (confinement.hpp)
  uid_t user = 0;  ///< run as this user and group, with no others; 0: unchanged
};

struct ProcessResult {
  int exit_code = -1;  ///< -1 if a signal ended it; 127 if there is no such program
  int signal = 0;
  bool out_of_time = false;     ///< exceeded its wall_seconds
  std::string output;           ///< standard output
  std::string errors;           ///< standard error
  double cpu_seconds = 0;       ///< of all that it started; of what it left, if it is confined
  std::size_t peak_memory = 0;  ///< resident, in bytes, of the largest
  std::size_t written = 0;      ///< bytes to disk, if the system counts them
  bool succeeded() const { return exit_code == 0; }
};

/// Runs `command`, a program and its arguments. Throws std::system_error if the machine has no
/// process or descriptor left. What it started ends with it.
ProcessResult run_process(const std::vector<std::string>& command,
                          const ProcessOptions& options = {});

/// Exit code of a child that could not execute its program.
constexpr int exit_not_started = 121;

/// The program's path according to PATH; `name` itself if it has a slash or is not found.
std::string found_in_path(const std::string& name);

}  // namespace mc::sandbox
