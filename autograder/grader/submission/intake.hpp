#pragma once
// What people hand in, wherever they put it: directories, zips, a whole class of them.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "grader/checkout/context.hpp"
#include "grader/submission/scratch.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

/// One person's work, or why it cannot be read.
struct IntakeEntry {
  Submission submission;   ///< its label is its id: unique, and fit to be shown
  std::string unreadable;  ///< why; empty where it could be read. No files is readable
};

struct Intake {
  std::vector<IntakeEntry> entries;
  bool each_word_is_one = false;  ///< what was decided where several were named
  /// What was unpacked, and goes with this.
  std::vector<std::unique_ptr<ScratchDirectory>> unpacked;
};

enum class Meaning {
  one,   ///< each word is one person's work, however it is laid out
  many,  ///< a directory or zip that holds several people's is theirs
};

/// Takes in directories and zips. Looks for a person's files at the top, else in starter/, else
/// anywhere below (skipping links, .git, build, __MACOSX) if each is there exactly once. A directory
/// that belongs to no single person means its children, directories and zips, in the order of their
/// names; so do the exports of Gradescope, Canvas (name_12_34_variance.cpp, all in one directory)
/// and Moodle (name_12_assignsubmission_file_). Several words are one submission each, unless all
/// of them are such exports. Unreadable entries are included, with the reason.
Intake take_in(const Context& context, const std::vector<std::string>& words, Meaning meaning);

/// One person's work, as `check` and Gradescope name it. Throws UsageError for what cannot be read.
Intake take_in_one(const Context& context, const std::filesystem::path& place);

}  // namespace mc::grader
