#pragma once
// git and gnuplot, without the configuration of the person who types.

#include <filesystem>
#include <string>
#include <vector>

#include "sandbox/process.hpp"

namespace mc::sandbox {

/// `git -C DIRECTORY WORDS…`. The files have the bytes of the repository; commits are not signed
/// and run no hooks; their author is the course, unless a later "-c user.name=…" says otherwise.
inline ProcessResult run_git(const std::filesystem::path& directory,
                             const std::vector<std::string>& words, ProcessOptions options = {}) {
  std::vector<std::string> command{"git", "-C", directory.string()};
  for (const char* setting :
       {"commit.gpgsign=false", "tag.gpgsign=false", "core.hooksPath=/dev/null",
        "core.excludesFile=", "core.attributesFile=", "core.autocrlf=false", "core.fsmonitor=false",
        "init.templateDir=", "safe.directory=*", "user.name=Monte Carlo labs",
        "user.email=labs@localhost"}) {
    command.insert(command.end(), {"-c", setting});
  }
  command.insert(command.end(), words.begin(), words.end());
  options.environment.emplace_back("GIT_CONFIG_NOSYSTEM", "1");
  return run_process(command, options);
}

/// Runs a script of gnuplot without ~/.gnuplot and the system's gnuplotrc.
inline ProcessResult run_gnuplot(const std::filesystem::path& script) {
  return run_process({"gnuplot", "-d", script.string()}, {.wall_seconds = 120});
}

}  // namespace mc::sandbox
