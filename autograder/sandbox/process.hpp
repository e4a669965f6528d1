#pragma once
// Runs a trusted program (a compiler, the checks, gnuplot) and waits for it.

#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace mc::sandbox {

class Confinement;

struct ProcessOptions {
  std::filesystem::path directory = {};                               ///< to run in; empty: here
  std::vector<std::pair<std::string, std::string>> environment = {};  ///< on top of our own
  /// Ours, and what it is called over there: a number below 16.
  std::vector<std::pair<int, int>> descriptors = {};
  double cpu_seconds = 0;  ///< limits; 0: none. Of each process that it starts.
  double wall_seconds = 0;
  std::size_t memory = 0;                     ///< address space
  std::size_t file_size = 0;                  ///< of each file that it writes
  std::size_t output = std::size_t{4} << 20;  ///< kept of what it says; the rest is thrown away
  const std::atomic<bool>* stop = nullptr;    ///< ends it soon after this has become true
  /// For a program that reads untrusted text: what it may do. Its output goes into files, so that
  /// a text that has it read its own output (/proc/self/fd/1) finds an end.
  const Confinement* confinement = nullptr;
  uid_t user = 0;  ///< becomes this user and group, with no others; 0: stays who it is
};

struct ProcessResult {
  int exit_code = -1;  ///< -1 where a signal ended it; 127 where there is no such program
  int signal = 0;
  bool out_of_time = false;     ///< of its wall_seconds
  std::string output;           ///< standard output
  std::string errors;           ///< standard error
  double cpu_seconds = 0;       ///< with that of the processes that it waited for
  std::size_t peak_memory = 0;  ///< resident, in bytes, of the largest
  std::size_t written = 0;      ///< bytes to disk, where the system counts them
  bool succeeded() const { return exit_code == 0; }
};

/// Throws std::system_error where the machine has no process or descriptor left.
ProcessResult run_process(const std::vector<std::string>& command,
                          const ProcessOptions& options = {});

/// Exit code of a child that could not even become the program it should.
constexpr int exit_not_started = 121;

/// What getrusage's ru_maxrss counts in.
#ifdef __APPLE__
constexpr std::size_t rusage_memory_unit = 1;
#else
constexpr std::size_t rusage_memory_unit = 1024;
#endif

}  // namespace mc::sandbox
