#pragma once
// Verdicts as pages: self-contained files, readable in light and dark mode, on a phone, and by a
// screen reader.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "grader/judging/verdict.hpp"

namespace mc::grader {

/// What a submission's page shows in addition to its verdict, by the lab's name.
struct PageMaterial {
  std::map<std::string, std::string> sources;                          ///< the text of its file
  std::map<std::string, std::vector<std::filesystem::path>> pictures;  ///< SVG files, inlined
  std::string corrections = {};  ///< made by hand: "variance: 91 (comment)"
};

/// The page of one submission.
std::string submission_page(const Verdict& verdict, const PageMaterial& material);

/// The beginning of a <div> that scrolls if it is wider than the window, by keyboard, too. Its
/// label is different from that of every other region of the page.
std::string scrolling(const std::string& label);

/// A complete, self-contained page around a body.
std::string html_page(const std::string& title, const std::string& body);

/// Text escaped for HTML.
std::string html_escaped(std::string_view text);

}  // namespace mc::grader
