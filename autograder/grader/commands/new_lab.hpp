#pragma once
// The skeleton of a lab.

#include <filesystem>
#include <string>
#include <vector>

namespace mc::grader {

/// Writes the files of a new lab below `root`, from sections "==== PATH" of the skeleton, in which
/// @lab@, @number@, @title@ and @folder@ are replaced. Returns their paths relative to `root`.
/// Throws UsageError, with nothing written, for a bad name or if a file exists.
std::vector<std::filesystem::path> write_new_lab(const std::filesystem::path& skeleton, int number,
                                                 const std::string& name,
                                                 const std::filesystem::path& root);

}  // namespace mc::grader
