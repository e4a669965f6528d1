#pragma once
// Reads submissions: one person's directory or archive in any layout, and a class of them.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/submission/scratch.hpp"
#include "judge/submission/submission.hpp"

namespace mc::grader {

/// One person's work, or why it cannot be read.
struct IntakeEntry {
  Submission submission;   ///< its label is its id: unique, safe to show, a valid file name
  std::string unreadable;  ///< why; empty if it could be read. A readable entry may have no files
};

struct Intake {
  std::vector<IntakeEntry> entries;
  std::vector<std::string> left_out;  ///< files of a class that belong to no student
  /// Unpacked files, removed with this object.
  std::vector<std::unique_ptr<ScratchDirectory>> unpacked;
};

/// The longest id, in characters.
inline constexpr std::size_t longest_id = 60;

/// Each word, a directory or an archive, is one submission. Looks for its files at the top, else in
/// starter/, else anywhere below (skipping links, .git, build, __MACOSX) if each is there exactly
/// once; and in an archive that is alone there. Unreadable entries are included, with the reason.
Intake take_in(const Context& context, const std::vector<std::string>& words);

/// Each directory and each archive in this directory or archive is one student, whatever it is
/// called; the id is its name. (In an archive that holds one directory and nothing else, that
/// directory is meant.) Files whose names have the form of Canvas, Moodle or
/// Blackboard belong to the person that the platform put in front. Everything else is left out.
Intake take_in_class(const Context& context, const std::filesystem::path& place);

/// One person's work, for `check` and Gradescope. Throws UsageError if it cannot be read.
Intake take_in_one(const Context& context, const std::filesystem::path& place);

}  // namespace mc::grader
