#pragma once
// A part of this repository for students or graders: no answers, and only some labs.

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/checkout/context.hpp"

namespace mc::grader {

/// Runs git in that directory and returns its output. Throws MachineError if it fails.
std::string git(const std::filesystem::path& directory, std::vector<std::string> words);

/// The labs named by a list such as "1,2", and those they depend on; all labs without a list.
std::set<std::string> labs_and_those_below(const Context& context,
                                           const std::optional<std::string>& list);

/// Does the copy have the judge as programs, or its sources?
enum class JudgeForm { compiled, sources };

/// The files that git tracks, so no builds and no private files; without answers and files that
/// only the repository needs; of the labs, only these.
std::vector<std::string> files_without_answers(const Context& context,
                                               const std::set<std::string>& labs, JudgeForm form);

/// Could this machine link the judge statically? Not on macOS, and not without static libraries.
bool has_compiled_judge(const Layout& layout);

/// Copies the compiled judge for these labs into autograder/bin of `to`, with the script that
/// starts it. Throws MachineError if this machine could not link it statically.
void copy_compiled_judge(const Context& context, const std::set<std::string>& labs,
                         const std::filesystem::path& to);

/// Copies a file and creates the directories it needs.
void copy_into(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace mc::grader
