#include "grader/pictures/demo.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "grader/base/replace.hpp"
#include "grader/base/text_file.hpp"
#include "grader/judging/judge.hpp"
#include "grader/pictures/plots.hpp"
#include "grader/reports/html.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/scratch.hpp"
#include "protocol/environment.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
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

}  // namespace

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
  const fs::path pictures = context.layout.root / "autograder/grader/pictures";
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

}  // namespace mc::grader
