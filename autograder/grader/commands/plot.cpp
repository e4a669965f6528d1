// plot: draws a lab's plots, several submissions side by side.

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/commands/command.hpp"
#include "grader/pictures/plots.hpp"
#include "grader/reports/progress_line.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

int plot(const Context& context, const Arguments& arguments) {
  if (arguments.words.empty()) throw UsageError("usage: ./lab plot LAB [DIR...]");
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  std::vector<Submission> submissions = submissions_with_solutions(
      context, lab, {arguments.words.begin() + 1, arguments.words.end()});
  std::string folder = "side-by-side";
  if (arguments.has("alone")) {
    submissions.resize(std::max<std::size_t>(1, arguments.words.size() - 1));
    folder = fs::path(submissions[0].label + "/.").parent_path().filename().string();
  }
  const Plots plots = [&] {
    const ProgressLine line("measuring and drawing " + lab.name);
    return draw_plots(context.layout, lab, submissions, folder);
  }();
  for (const std::string& remark : plots.remarks) fmt::print("{}\n", remark);
  for (const fs::path& picture : plots.pictures) fmt::print("{}\n", picture.string());
  return plots.pictures.empty() ? 1 : 0;
}

const RegisterCommand plot_command{
    {"plot",
     "plot LAB [DIR...] [--alone]",
     {"alone"},
     "Draws starter/ if no DIR is named, next to the solutions if the checkout has them.\n"
     "  --alone   without the solutions\n",
     plot}};

}  // namespace
}  // namespace mc::grader
