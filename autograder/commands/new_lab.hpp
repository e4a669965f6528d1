#pragma once
// The skeleton of a lab.

#include "commands/command.hpp"

namespace mc::grader {

/// Writes the files of a new lab below `root`: those of the skeleton's directory, in whose names
/// and texts @lab@, @number@, @title@ and @folder@ are replaced. Returns their paths relative to
/// `root`. Throws UsageError, with nothing written, for a bad name or if a file exists.
std::vector<fs::path> write_new_lab(const fs::path& skeleton, int number, const std::string& name,
                                    const fs::path& root);

}  // namespace mc::grader
