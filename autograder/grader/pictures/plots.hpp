#pragma once
// Draws a lab's plots with gnuplot from measurements.

#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/pictures/gnuplot.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

/// Measures the submissions and draws them side by side, into build/plots/<folder>. Without gnuplot
/// there are no pictures, only a remark.
Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder);

}  // namespace mc::grader
