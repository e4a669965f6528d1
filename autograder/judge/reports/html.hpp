#pragma once
// Pages: the verdict on a submission, with its pictures. A page needs no other file.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "judge/judging/verdict.hpp"

namespace mc::grader {

/// The text for the body of a page or an attribute.
std::string html_escaped(std::string_view text);

/// A whole page with this body, in the style of all pages.
std::string html_page(const std::string& title, const std::string& body);

/// SVG files by lab name, in the order in which the page shows them.
using Pictures = std::map<std::string, std::vector<std::filesystem::path>>;

/// The page of a submission: each check with its report.
std::string submission_page(const Verdict& verdict, const Pictures& pictures);

}  // namespace mc::grader
