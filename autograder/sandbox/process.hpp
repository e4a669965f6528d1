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

struct ProcessOptions {
  std::filesystem::path directory = {};                               ///< working directory
  std::vector<std::pair<std::string, std::string>> environment = {};  ///< added to our own
  /// Our descriptors, and their numbers in the child, below 16.
  std::vector<std::pair<int, int>> descriptors = {};
  double cpu_seconds = 0;  ///< limits, for each process it starts; 0: none
  double wall_seconds = 0;
  std::size_t memory = 0;                     ///< address space
  std::size_t file_size = 0;                  ///< of each file that it writes
  std::size_t output = std::size_t{4} << 20;  ///< bytes of output kept; the rest is discarded
  const std::atomic<bool>* stop = nullptr;    ///< stops it soon after this becomes true
  /// A program that reads untrusted text: it may write only in `directory` and has no network
  /// (confinement.hpp). Its output goes to files, so that a text that makes it read its own output
  /// (/proc/self/fd/1) reaches an end.
  bool confined = false;
  uid_t user = 0;  ///< run as this user and group, with no others; 0: unchanged
};

struct ProcessResult {
  int exit_code = -1;  ///< -1 if a signal ended it; 127 if there is no such program
  int signal = 0;
  bool out_of_time = false;     ///< exceeded its wall_seconds
  std::string output;           ///< standard output
  std::string errors;           ///< standard error
  double cpu_seconds = 0;       ///< including the processes that it waited for
  std::size_t peak_memory = 0;  ///< resident, in bytes, of the largest
  std::size_t written = 0;      ///< bytes to disk, if the system counts them
  bool succeeded() const { return exit_code == 0; }
};

/// Runs `command`, a program and its arguments. Throws std::system_error if the machine has no
/// process or descriptor left.
ProcessResult run_process(const std::vector<std::string>& command,
                          const ProcessOptions& options = {});

/// Exit code of a child that could not execute its program.
constexpr int exit_not_started = 121;

/// The program's path according to PATH; `name` itself if it has a slash or is not found.
std::string found_in_path(const std::string& name);

}  // namespace mc::sandbox
