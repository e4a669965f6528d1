#pragma once
// Runs a trusted program (a compiler, the checks, gnuplot) and waits for it.

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace mc::grader {

struct ProcessOptions {
  std::filesystem::path directory = {};                               ///< to run in; empty: here
  std::vector<std::pair<std::string, std::string>> environment = {};  ///< on top of our own
  std::vector<std::pair<int, int>> descriptors = {};  ///< ours, and what it is called over there
  double cpu_seconds = 0;                             ///< limits; 0: none
  double wall_seconds = 0;
  std::size_t memory = 0;                     ///< address space
  std::size_t file_size = 0;                  ///< of each file that it writes
  std::size_t output = std::size_t{4} << 20;  ///< kept of what it says; the rest is thrown away
  const std::atomic<bool>* stop = nullptr;    ///< ends it soon after this has become true
};

struct ProcessResult {
  int exit_code = -1;  ///< -1 where a signal ended it
  int signal = 0;
  bool out_of_time = false;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
  double cpu_seconds = 0;
  std::size_t peak_memory = 0;  ///< resident, in bytes
  bool succeeded() const { return exit_code == 0; }
};

/// Throws std::system_error where no process can be made; a program that is not there ends with
/// exit code 127.
ProcessResult run_process(const std::vector<std::string>& command,
                          const ProcessOptions& options = {});

/// An anonymous pipe, both ends closed on exec.
std::pair<int, int> make_pipe();

}  // namespace mc::grader
