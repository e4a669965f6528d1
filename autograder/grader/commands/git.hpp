#pragma once
// Runs git in a directory.

#include "grader/commands/command.hpp"
#include "runner/text.hpp"
#include "sandbox/programs.hpp"

namespace mc::grader {

using sandbox::run_git;

/// Its output. Throws MachineError if it fails.
inline std::string git(const fs::path& directory, const std::vector<std::string>& words) {
  const auto run = run_git(directory, words);
  if (!run.succeeded()) {
    throw MachineError(fmt::format("git -C {} {}: {}", directory.string(), fmt::join(words, " "),
                                   sandbox::printable_line(run.errors.substr(0, 200))));
  }
  return run.output;
}

/// The lines that it prints; none if it fails.
inline std::vector<std::string> git_lines(const fs::path& directory,
                                          const std::vector<std::string>& words) {
  std::vector<std::string> lines;
  const auto run = run_git(directory, words);
  if (!run.succeeded()) return lines;
  for (const std::string_view line : text::split(run.output, '\n')) {
    if (!line.empty()) lines.emplace_back(line);
  }
  return lines;
}

}  // namespace mc::grader
