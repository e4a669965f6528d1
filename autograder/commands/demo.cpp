// demo: the interactive page, what a slider teaches in each lab, with the points of a submission.

#include <map>

#include "commands/command.hpp"
#include "judge/base/replace.hpp"
#include "judge/judging/judge.hpp"
#include "judge/pictures/plots.hpp"
#include "judge/reports/html.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/submission/build.hpp"
#include "judge/submission/scratch.hpp"
#include "protocol/environment.hpp"

namespace mc::grader {
namespace {

constexpr const char* tag = "[.demo]";

std::vector<Lab> labs_in_demo(const Context& context) {
  std::vector<Lab> labs;
  for (const Lab& lab : context.labs) {
    if (!fs::exists(context.layout.measurements(lab.name))) continue;
    if (!hidden_cases(context.layout, lab, CaseKind::measurements, tag).empty())
      labs.push_back(lab);
  }
  return labs;
}

/// Measures one lab; `records` are JSON texts by file name.
void measure(const Layout& layout, const Lab& lab, const Submission& submission,
             const fs::path& data, std::map<std::string, std::string>& records,
             std::vector<std::string>& remarks) {
  const BuildResult built = build_program(layout, lab, submission);
  if (!built.program) {
    const std::string why = built.failure.substr(0, built.failure.find('\n'));
    remarks.push_back(fmt::format("lab {}: {}", lab.number, why));
    return;
  }
  fs::create_directories(data);
  run_hidden_cases(
      layout, lab, CaseKind::measurements, *built.program, tag,
      {.environment = {{protocol::plot_data_variable, data.string()}}, .wall_seconds = 600});
  for (const auto& entry : fs::directory_iterator(data)) {
    if (entry.path().extension() != ".json") continue;
    std::string text = read_text(entry.path());
    if (!text.empty()) records[entry.path().filename().string()] = std::move(text);
  }
  for (const std::string& reason : missing_in(data)) {
    remarks.push_back(fmt::format("lab {}: {}", lab.number, reason));
  }
}

std::string list_of(const std::vector<std::string>& remarks) {
  if (remarks.empty()) return {};
  std::string all = "<h2>Not measured</h2>\n<ul>\n";
  for (const std::string& remark : remarks) all += "<li>" + html_escaped(remark) + "</li>\n";
  return all + "</ul>";
}

struct Demo {
  std::string page;                  ///< self-contained; empty if there is nothing to show
  std::vector<std::string> remarks;  ///< what could not be measured, and why
};

/// Measures every lab that has a hidden case tagged [.demo].
Demo make_demo(const Context& context, const Submission& submission) {
  Demo demo;
  const ScratchDirectory scratch(context.layout);
  std::map<std::string, std::string> records;
  for (const Lab& lab : labs_in_demo(context)) {
    if (!submission.files.contains(lab.name)) {
      demo.remarks.push_back(fmt::format("lab {}: there is no {}", lab.number, lab.file()));
      continue;
    }
    measure(context.layout, lab, submission, scratch.path() / lab.name, records, demo.remarks);
  }
  if (records.empty()) return demo;
  std::string data;
  for (const auto& [name, text] : records) data += (data.empty() ? "[" : ",\n") + text;
  const fs::path pictures = context.layout.root / "autograder/judge/pictures";
  demo.page = read_whole_text(pictures / "demo.html");
  const std::pair<const char*, std::string> parts[] = {
      {"SCRIPT",
       read_whole_text(pictures / "demo.js") + read_whole_text(pictures / "demo_labs.js")},
      {"REMARKS", list_of(demo.remarks)},
      {"SUBMISSION", html_escaped(sandbox::printable_line(submission.label))},
      {"VERSION", html_escaped(context.layout.version)},
      {"DATA", data + ']'}};
  for (const auto& [name, text] : parts) {
    demo.page = with_replacements(demo.page, {{fmt::format("<!--{}-->", name), text}});
  }
  return demo;
}

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
     .about = "make a page with an interactive figure for each lab, from your own points",
     .details = "One self-contained page with an interactive figure per lab: digits, error bars, "
                "strata, spectra, elementary intervals, pictures. Measures the solutions if the "
                "checkout has them, otherwise starter/.",
     .options = {{"--out F.html", "the file (build/demo.html)"},
                 {"--dir DIR", "measure this submission instead"}},
     .run = demo,
     .most_words = 0,
     .place = "autograder/judge/pictures/demo.html",
     .targets = [](const Context& context, const Arguments&) {
       return targets_of_all(context, "measure_");
     }}};

}  // namespace
}  // namespace mc::grader
