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
  if (arguments.has("alone")) {
    submissions.resize(std::max<std::size_t>(1, arguments.words.size() - 1));
  }
  std::vector<std::string> names;
  for (const Submission& one : submissions) {
    names.push_back(fs::canonical(one.path).filename().string());
  }
  // A folder for each choice of submissions: other pictures stay. A file name has 255 bytes at
  // most.
  const std::string folder = fmt::format("{}", fmt::join(names, "-")).substr(0, 200);
  const Plots plots = [&] {
    const ProgressLine line("measuring and drawing " + lab.name);
    return draw_plots(context.layout, lab, submissions, folder);
  }();
  for (const std::string& remark : plots.remarks) fmt::print("{}\n", remark);
  if (names.size() > 1) fmt::print("Left to right: {}\n", fmt::join(names, ", "));
  for (const std::string& line : plots.descriptions) fmt::print("{}\n", line);
  return plots.pictures.empty() ? 1 : 0;
}

const RegisterCommand plot_command{
    {.usage = "plot LAB [DIR...] [--alone]",
     .about = "draw the lab's plots, several submissions side by side",
     .details =
         "Draws starter/ if no DIR is named, next to the solutions if the checkout has them, into "
         "build/plots/NAMES: DIR1-DIR2 is apart from DIR1.",
     .options = {{"--alone", "without the solutions"}},
     .run = plot,
     .least_words = 1,
     .targets = target_of_lab<measure_target>}};

}  // namespace
}  // namespace mc::grader
