// plot: draws a lab's plots, several submissions side by side.

#include <algorithm>

#include "commands/command.hpp"
#include "judge/pictures/plots.hpp"
#include "judge/reports/progress_line.hpp"

namespace mc::grader {
namespace {

int plot(const Context& context, const Arguments& arguments) {
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  std::vector<Submission> submissions =
      submissions_with_solutions(context, lab, arguments.words_after(1));
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
    {.usage = "plot LAB [DIR...] [--alone]",
     .about = "draw the lab's plots, several submissions side by side",
     .details =
         "Draws starter/ if no DIR is named, next to the solutions if the checkout has them.",
     .options = {{"--alone", "without the solutions"}},
     .run = plot,
     .least_words = 1,
     .targets = target_of_lab<measure_target>}};

}  // namespace
}  // namespace mc::grader
