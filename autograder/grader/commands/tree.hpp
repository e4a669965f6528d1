#pragma once
// A part of this repository for students or graders: no answers, and only some labs.

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/checkout/context.hpp"

namespace mc::grader {

/// Runs git there; gives back what it says. Throws MachineError where it fails.
std::string git(const std::filesystem::path& directory, std::vector<std::string> words);

/// The labs named "1,2", and those they stand on; all without a list.
std::set<std::string> labs_and_those_below(const Context& context,
                                           const std::optional<std::string>& list);

/// The files that git lists, so no build and no file of one's own; nothing that holds answers or is
/// of use to the repository only; of the labs, these.
std::vector<std::string> files_without_answers(const Context& context,
                                               const std::set<std::string>& labs);

/// Copies it, and makes the directories that it needs.
void copy_into(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace mc::grader
