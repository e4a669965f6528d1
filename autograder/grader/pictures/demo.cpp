#include "grader/pictures/demo.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include <fmt/format.h>

#include "grader/base/errors.hpp"
#include "grader/base/text_file.hpp"
#include "grader/judging/judge.hpp"
#include "grader/reports/html.hpp"
#include "grader/submission/build.hpp"
#include "grader/submission/scratch.hpp"
#include "protocol/environment.hpp"
#include "runner/text.hpp"
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

/// Why a lab's output is missing.
void add_reasons(const Lab& lab, const fs::path& data, std::vector<std::string>& remarks) {
  std::set<std::string> reasons;
  for (const auto& entry : fs::directory_iterator(data)) {
    if (entry.path().extension() != ".missing") continue;
    const std::string lines = read_text(entry.path());
    for (const std::string_view line : text::split(lines, '\n')) {
      if (!line.empty()) reasons.insert(sandbox::printable_line(line));
    }
  }
  for (const std::string& reason : reasons) {
    remarks.push_back(fmt::format("lab {}: {}", lab.number, reason));
  }
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
  add_reasons(lab, data, remarks);
}

/// Replaces a comment by `text`.
void fill(std::string& page, const char* name, const std::string& text) {
  const std::string mark = fmt::format("<!--{}-->", name);
  const auto at = page.find(mark);
  if (at == std::string::npos) throw MachineError("demo.html has no " + mark);
  page.replace(at, mark.size(), text);
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
  fill(demo.page, "SCRIPT",
       read_whole_text(pictures / "demo.js") + read_whole_text(pictures / "demo_labs.js"));
  fill(demo.page, "REMARKS", list_of(demo.remarks));
  fill(demo.page, "SUBMISSION", html_escaped(sandbox::printable_line(submission.label)));
  fill(demo.page, "VERSION", html_escaped(context.layout.version));
  fill(demo.page, "DATA", data + ']');
  return demo;
}

}  // namespace mc::grader
