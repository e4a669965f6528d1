// demo: the interactive page.

#include <filesystem>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/commands/command.hpp"
#include "grader/commands/judging_options.hpp"
#include "grader/pictures/demo.hpp"
#include "grader/reports/progress_line.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

namespace fs = std::filesystem;

int demo(const Context& context, const Arguments& arguments) {
  if (!arguments.words.empty()) throw UsageError("usage: ./lab demo [--out F.html] [--dir DIR]");
  const Layout& layout = context.layout;
  const auto out = arguments.get("out");
  require_writable(out);
  const bool has_solutions = fs::exists(layout.solutions());
  const auto given = arguments.get("dir");
  const fs::path directory = given           ? fs::path(*given)
                             : has_solutions ? layout.solutions()
                                             : layout.starter();
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
  const fs::path file = out ? fs::path(*out) : layout.build / "demo.html";
  write_text(file, made.page);
  fmt::print("{}\n", sandbox::printable_line(file.string()));
  return 0;
}

const RegisterCommand demo_command{
    {"demo",
     "demo [--out F.html] [--dir DIR]",
     {"out=", "dir="},
     "One self-contained page with an interactive figure per lab: digits, error bars, strata,\n"
     "spectra, elementary intervals, pictures. Measures the solutions if the checkout has them,\n"
     "otherwise starter/.\n"
     "  --out F.html  the file (build/demo.html)\n"
     "  --dir DIR     measure this submission instead\n",
     demo}};

}  // namespace
}  // namespace mc::grader
