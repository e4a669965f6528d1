#pragma once
// A class as HTML pages: its statistics, and a page per submission.

#include "grader/gradebook/statistics.hpp"
#include "grader/submission/intake.hpp"

namespace mc::grader {

/// The statistics as a page, without names.
std::string statistics_page(const ClassStatistics& statistics);

/// Writes directory/index.html with all points and the statistics, and a page for each submission
/// that has a verdict: its failures and its source.
void write_class_pages(const std::filesystem::path& directory, const Context& context,
                       const Table& table, const std::vector<IntakeEntry>& entries);

}  // namespace mc::grader
