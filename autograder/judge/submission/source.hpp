#pragma once
// A submitted source file. Its size and kind are checked before it is read.

#include <filesystem>
#include <map>
#include <string>

namespace mc::grader {

/// The size limit of a source file, in bytes.
constexpr std::size_t longest_source = std::size_t{1} << 20;

struct SourceFile {
  std::string text;
  std::string problem;  ///< why it is not accepted, for the student; empty if it is
};

/// The text of a regular file of at most `longest_source` bytes; links are not followed. Throws
/// std::system_error if the machine fails (no descriptors, no memory, a broken disk).
SourceFile read_source(const std::filesystem::path& file);

/// All submitted files in one text: two submissions are the same if their texts are equal. A file
/// that is not accepted is represented by its problem.
std::string contents_of(const std::map<std::string, std::filesystem::path>& files);

/// Is the error one of the machine, not of the submission: no descriptors, no memory, no disk?
bool is_machine_fault(const std::error_code& code);

}  // namespace mc::grader
