#pragma once
// Verdicts as pages: self-contained files, nothing from elsewhere, readable in light and dark, on a
// phone, by a screen reader.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// What a submission's page shows in addition to its verdict, by the lab's name.
struct PageMaterial {
  std::map<std::string, std::string> sources;                          ///< the text of its file
  std::map<std::string, std::vector<std::filesystem::path>> pictures;  ///< SVG files, put inline
  std::string corrections = {};  ///< by hand: "variance: 91 (comment)"
};

/// The page of one submission.
std::string submission_page(const Verdict& verdict, const PageMaterial& material);

/// A whole page around its body: everything that it needs is in it.
std::string html_page(const std::string& title, const std::string& body);

/// Text as HTML has it.
std::string html_escaped(std::string_view text);

}  // namespace mc::grader
