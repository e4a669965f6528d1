// report: the student's work as a page.

#include <cstdlib>

#include "grader/commands/command.hpp"
#include "grader/judging/judge_submission.hpp"
#include "grader/pictures/plots.hpp"
#include "grader/reports/html.hpp"
#include "grader/reports/progress_line.hpp"
#include "sandbox/process.hpp"

namespace mc::grader {
namespace {

/// Shows a file in a browser if there is a browser and a display.
void open_in_browser(const fs::path& file) {
#ifdef __APPLE__
  sandbox::run_process({"open", file.string()});
#else
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  sandbox::run_process({"xdg-open", file.string()}, {.wall_seconds = 10});
#endif
}

int report(const Context& context, const Arguments& arguments) {
  const Lab& lab = find_lab(context.labs, arguments.words[0]);
  const bool is_own = arguments.words.size() == 1;
  Submission submission = open_submission(
      context.labs, is_own ? context.layout.starter() : fs::path(arguments.words[1]));
  if (is_own) submission.label = "starter";
  if (!submission.files.contains(lab.name)) {
    throw UsageError(fmt::format("{} has no {}", submission.label, lab.file()));
  }
  SubmissionOptions options;
  options.judge.seed = arguments.seed();
  ProgressLine line("checking " + lab.name);
  options.progress = [&](double done, double all, const std::string& what) {
    line.show(100 * done, 100 * all, what);
  };
  const Verdict verdict = judge_submission(context, submission, {lab}, options);
  PageMaterial material;
  material.sources[lab.name] = read_text(submission.files.at(lab.name));
  line.show(0, 0, "drawing " + lab.name);
  if (verdict.labs[0].no_program.empty()) {
    const auto compared = submissions_with_solutions(context, lab, arguments.words_after(1));
    for (const fs::path& picture : draw_plots(context.layout, lab, compared, "report").pictures) {
      if (picture.extension() == ".svg") material.pictures[lab.name].push_back(picture);
    }
  }
  const fs::path page = context.layout.build / "report" / (lab.name + ".html");
  fs::create_directories(page.parent_path());
  write_text(page, submission_page(verdict, material));
  line.clear();
  fmt::print("{:g} of {:g} points: {}\n", verdict.earned(), verdict.points(), page.string());
  if (!arguments.has("no-browser")) open_in_browser(page);
  return 0;
}

const RegisterCommand report_command{
    {.usage = "report LAB [DIR] [--seed S] [--no-browser]",
     .details = "Writes the verdict, your code with the compiler's messages at their lines, your "
                "plots and your speed to build/report/LAB.html, and opens it if there is a "
                "browser.",
     .options = {{"--seed S", "repeat the run with that seed"},
                 {"--no-browser", "only write the page"}},
     .run = report,
     .least_words = 1,
     .most_words = 2}};

}  // namespace
}  // namespace mc::grader
