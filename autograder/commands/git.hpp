#pragma once
// Runs git in a directory, without the personal settings of the user.

#include "commands/command.hpp"
#include "sandbox/programs.hpp"

namespace mc::grader {

/// Its output. Throws MachineError if it fails or is absent.
inline std::string git(const fs::path& directory, const std::vector<std::string>& words) {
  const auto run = sandbox::run_git(directory, words, {.output = std::size_t{64} << 20});
  if (run.exit_code == 127) throw MachineError("git is not installed");
  if (!run.succeeded()) {
    throw MachineError(fmt::format("git -C {} {}: {}", directory.string(), words[0],
                                   sandbox::printable_line(run.errors.substr(0, 200))));
  }
  return run.output;
}

}  // namespace mc::grader
