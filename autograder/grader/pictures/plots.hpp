#pragma once
// A lab's plots, drawn by gnuplot from measurements.

#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "grader/pictures/gnuplot.hpp"
#include "grader/submission/submission.hpp"

namespace mc::grader {

/// Measures each submission and draws them side by side, into build/plots/<folder>. Without
/// gnuplot: no pictures, and a remark.
Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder);

}  // namespace mc::grader
