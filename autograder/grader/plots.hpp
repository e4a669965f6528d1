#pragma once
// A lab's plots, drawn by gnuplot from measurements.

#include <filesystem>
#include <string>
#include <vector>

#include "grader/bench.hpp"
#include "grader/build.hpp"
#include "grader/labs.hpp"
#include "grader/layout.hpp"
#include "grader/submission.hpp"

namespace mc::grader {

struct Plots {
  std::vector<std::filesystem::path> pictures;  ///< SVG and PNG of each plot
  std::vector<std::string> remarks;             ///< what could not be drawn, and why
};

/// Measures each submission and draws them side by side, into build/plots/<folder>. Without
/// gnuplot: no pictures, and a remark.
Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder);

/// The pictures of the bench, into `place`.
Plots draw_bench(const Layout& layout, const Bench& bench, const std::filesystem::path& place);

// What drawing is made of, for other pictures too (renders.hpp).

/// Is gnuplot there?
bool gnuplot_is_there();

/// A string, and a list of strings, as gnuplot reads them.
std::string gnuplot_string(const std::string& text);
std::string gnuplot_array(const std::string& name, const std::vector<std::string>& texts);

/// Writes a script and runs it; what gnuplot complains of, or nothing.
std::string run_gnuplot(const std::filesystem::path& script, const std::string& text);

}  // namespace mc::grader
