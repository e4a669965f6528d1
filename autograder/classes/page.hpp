#pragma once
// The pages of a class: index.html with a table of students and tasks, and a page for each student.

#include <filesystem>
#include <functional>
#include <vector>

#include "judge/judging/verdict.hpp"
#include "judge/reports/html.hpp"

namespace mc::grader {

/// Writes index.html and submissions/ID.html into the directory. `pictures_of` draws what the page
/// of a student shows (it may be empty).
void write_class_pages(const std::filesystem::path& directory, const std::vector<Verdict>& verdicts,
                       const std::function<Pictures(std::size_t verdict)>& pictures_of);

}  // namespace mc::grader
