#pragma once
// A part of this repository for students or graders: no answers, and only some labs.

#include <set>

#include "commands/command.hpp"

namespace mc::grader {

/// The labs named by a list such as "1,2", and those they depend on; all labs without a list.
std::set<std::string> labs_with_dependencies(const Context& context,
                                             const std::optional<std::string>& list);

/// Does the copy have the judge as programs, or its sources?
enum class JudgeForm { compiled, sources };

/// Copies the course without answers and without files that only the repository needs; of the labs,
/// only these. In compiled form, the judge is in autograder/bin, with the script that starts it.
/// Throws MachineError if this machine could not link it statically, and UsageError for files that
/// are not in git.
void copy_course(const Context& context, const std::set<std::string>& labs, JudgeForm form,
                 const fs::path& to);

/// Could this machine link the judge statically? Not without static libraries.
bool has_compiled_judge(const Layout& layout);

/// Copies a file in place of an existing one, and creates the directories it needs.
void copy_into(const fs::path& from, const fs::path& to);

}  // namespace mc::grader
