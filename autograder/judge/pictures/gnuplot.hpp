#pragma once
// gnuplot: finds it, writes and runs scripts, and collects what they drew.

#include <filesystem>
#include <string>
#include <vector>

#include "judge/checkout/layout.hpp"

namespace mc::grader {

/// The result of drawing.
struct Plots {
  std::vector<std::filesystem::path> pictures;  ///< SVG and PNG of each plot
  std::vector<std::string> remarks;             ///< what could not be drawn, and why
  std::vector<std::string> descriptions = {};  ///< "…/variance-digits.svg, .png: Digits kept …"
};

/// Is gnuplot installed?
bool gnuplot_is_there();

/// The same, and adds a remark if it is not.
bool can_draw(Plots& plots);

/// A string, and a list of strings, quoted for gnuplot.
std::string gnuplot_string(std::string_view text);
std::string gnuplot_array(const std::string& name, const std::vector<std::string>& texts);

/// The beginning of every script: the output, its format, the style.
std::string script_beginning(const Layout& layout, const std::filesystem::path& out,
                             const std::string& extension);

/// Writes a script and runs it; returns gnuplot's complaints.
std::string run_gnuplot(const std::filesystem::path& script, const std::string& text);

/// Adds the pictures in `place` whose names begin with `start`.
void collect(Plots& plots, const std::filesystem::path& place, const std::string& start);

}  // namespace mc::grader
