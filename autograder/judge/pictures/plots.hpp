#pragma once
// Draws a lab's plots with gnuplot from measurements.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/judging/check_process.hpp"
#include "judge/pictures/gnuplot.hpp"
#include "judge/submission/submission.hpp"

namespace mc::grader {

/// Why measurements are missing in a directory of data: "halton is not written yet". Of one
/// picture, or of all.
std::set<std::string> missing_in(const std::filesystem::path& data,
                                 const std::string& picture = "");

/// Why a hidden case failed, in one line; empty if it did not.
std::string failure_of(const CheckProcess& run);

/// Measures the submissions and draws them side by side, into build/plots/<folder>. Without gnuplot
/// there are no pictures, only a remark.
Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder);

}  // namespace mc::grader
