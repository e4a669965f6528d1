#include "grader/pictures/plots.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "grader/judging/judge.hpp"
#include "grader/pictures/gnuplot.hpp"
#include "grader/submission/build.hpp"
#include "protocol/environment.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

std::string script_of(const Layout& layout, const Lab& lab, const std::vector<std::string>& labels,
                      const std::vector<fs::path>& data, const fs::path& out,
                      const std::string& extension) {
  const fs::path here = layout.labs() / lab.folder;
  return script_beginning(layout, out, extension) +
         fmt::format("count = {}\n{}{}here = {}\nload {}\n", labels.size(),
                     gnuplot_array("labels", labels),
                     gnuplot_array("data", std::vector<std::string>(data.begin(), data.end())),
                     gnuplot_string(here.string()), gnuplot_string((here / "plots.gp").string()));
}

}  // namespace

Plots draw_plots(const Layout& layout, const Lab& lab, const std::vector<Submission>& submissions,
                 const std::string& folder) {
  Plots plots;
  if (!can_draw(plots)) return plots;
  const fs::path place = layout.build / "plots" / folder;
  std::vector<std::string> labels;
  std::vector<fs::path> data;
  for (const Submission& submission : submissions) {
    const Built built = build_program(layout, lab, submission);
    if (!built.program) {
      plots.remarks.push_back(fmt::format("{} is not drawn: {}", submission.label, built.failure));
      continue;
    }
    const fs::path measured = place / "data" / fmt::format("{}-{}", lab.name, labels.size());
    fs::create_directories(measured);
    const sandbox::ProcessOptions options{
        .environment = {{protocol::plot_data_variable, measured.string()}}, .wall_seconds = 300};
    if (run_hidden_cases(layout, lab, CaseKind::figures, *built.program, "[.plot]", options)
            .succeeded()) {
      labels.push_back(submission.label);
      data.push_back(measured);
    } else {
      plots.remarks.push_back(submission.label + " is not drawn: its measurements failed");
    }
  }
  if (labels.empty()) return plots;
  draw(plots, place / "data" / lab.name, [&](const std::string& extension) {
    return script_of(layout, lab, labels, data, place / lab.name, extension);
  });
  collect(plots, place, lab.name + "-");
  return plots;
}

}  // namespace mc::grader
