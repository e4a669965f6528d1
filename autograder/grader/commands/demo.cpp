// demo: the interactive page.

#include "grader/pictures/demo.hpp"
#include "grader/commands/command.hpp"
#include "grader/reports/progress_line.hpp"

namespace mc::grader {
namespace {

int demo(const Context& context, const Arguments& arguments) {
  const Layout& layout = context.layout;
  const fs::path out = arguments.output("out").value_or(layout.build / "demo.html");
  const bool has_solutions = fs::exists(layout.solutions());
  const auto given = arguments.get("dir");
  const fs::path directory = given.value_or(has_solutions ? layout.solutions() : layout.starter());
  Submission submission = open_submission(context.labs, directory);
  if (!given) submission.label = has_solutions ? "the solutions" : "starter";
  const Demo made = [&] {
    const ProgressLine line("measuring");
    return make_demo(context, submission);
  }();
  for (const std::string& remark : made.remarks) fmt::print("{}\n", remark);
  if (made.page.empty()) {
    fmt::print("no page: none of the tasks that it shows is written yet\n");
    return 1;
  }
  write_text(out, made.page);
  fmt::print("{}\n", sandbox::printable_line(out.string()));
  return 0;
}

const RegisterCommand demo_command{
    {.usage = "demo [--out F.html] [--dir DIR]",
     .details = "One self-contained page with an interactive figure per lab: digits, error bars, "
                "strata, spectra, elementary intervals, pictures. Measures the solutions if the "
                "checkout has them, otherwise starter/.",
     .options = {{"--out F.html", "the file (build/demo.html)"},
                 {"--dir DIR", "measure this submission instead"}},
     .run = demo,
     .most_words = 0}};

}  // namespace
}  // namespace mc::grader
