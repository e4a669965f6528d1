#pragma once
// Points that a course gives, in place of those in the checks' tags: points.csv in the checkout.
//
//   what,points
//   1.3,12                          a task: its checks share 12 points as they did before
//   1.6 the covariance of pairs,8   a check
//   1.7,0                           left out: of handouts, reports and statistics

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/checkout/layout.hpp"
#include "judge/judging/verdict.hpp"

namespace mc::grader {

inline constexpr const char* points_file = "points.csv";

/// Sets the points of a lab's checks, and removes those that are left out. Throws UsageError,
/// naming the line, for a line that is not one of these or that names no check of its lab.
void apply_points(const std::filesystem::path& root, const Lab& lab, std::vector<Check>& checks);

/// Throws UsageError, naming the line, for a lab that does not exist or a task without a section in
/// its handout. Only for instructors: a student's handout may have fewer labs and tasks than the
/// file.
void require_known_points(const Layout& layout, const std::vector<Lab>& labs);

/// The tasks that are left out.
std::set<std::string> tasks_left_out(const std::filesystem::path& root);

/// A Markdown text without the section of that heading, "### 1.7".
std::string without_section(const std::string& text, const std::string& heading);

}  // namespace mc::grader
