#pragma once
// Reads submissions in any layout: directories, zips, a whole class.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/submission/scratch.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

/// One person's work, or why it cannot be read.
struct IntakeEntry {
  Submission submission;   ///< its label is its id: unique, and safe to show
  std::string unreadable;  ///< why; empty if it could be read. A readable entry may have no files
};

/// The text with ASCII capitals in lower case.
std::string in_lower_case(std::string text);

/// Appends " (2)", " (3)", … to labels that occur before. A label is also a file name, possibly on
/// a disk that ignores case.
void make_labels_unique(std::vector<IntakeEntry>& entries);

struct Intake {
  std::vector<IntakeEntry> entries;
  bool each_word_is_one = false;  ///< the decision for several words
  /// Unpacked files, removed with this object.
  std::vector<std::unique_ptr<ScratchDirectory>> unpacked;
};

enum class Meaning {
  one,   ///< each word is one person's work, in any layout
  many,  ///< a directory or zip may hold several people's work
};

/// Takes in directories and zips. Looks for a person's files at the top, else in starter/, else
/// anywhere below (skipping links, .git, build, __MACOSX) if each is there exactly once.
/// Directories of several people are split into their directories and zips, in the order of their
/// names; so are the exports of Gradescope, Canvas (name_12_34_variance.cpp, all in one directory)
/// and Moodle (name_12_assignsubmission_file_). Several words are one submission each, unless all
/// of them are such exports. Unreadable entries are included, with the reason.
Intake take_in(const Context& context, const std::vector<std::string>& words, Meaning meaning);

/// One person's work, for `check` and Gradescope. Throws UsageError if it cannot be read.
Intake take_in_one(const Context& context, const std::filesystem::path& place);

}  // namespace mc::grader
