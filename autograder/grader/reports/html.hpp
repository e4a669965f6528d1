#pragma once
// Verdicts as pages: self-contained files, nothing from elsewhere, readable in light and dark, on a
// phone, by a screen reader.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// What stands on a submission's page beside its verdict, by the lab's name.
struct PageMaterial {
  std::map<std::string, std::string> sources;                          ///< the text of its file
  std::map<std::string, std::vector<std::filesystem::path>> pictures;  ///< SVG files, put inline
};

/// The page of one submission.
std::string submission_page(const Verdict& verdict, const PageMaterial& material);

/// A row of the index.
struct IndexEntry {
  const Verdict* verdict;
  std::string page;  ///< the file's name, relative to the index; empty where there is no page
};

/// The index of a class: everybody's points, how they are distributed, and what most people miss.
std::string class_page(const std::vector<IndexEntry>& entries);

/// Text as HTML has it.
std::string html_escaped(std::string_view text);

}  // namespace mc::grader
