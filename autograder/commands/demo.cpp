// demo: the interactive page, what a slider teaches in each lab, with the points of a submission.

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "commands/command.hpp"
#include "commands/watch.hpp"
#include "judge/base/replace.hpp"
#include "judge/judging/judge.hpp"
#include "judge/pictures/plots.hpp"
#include "judge/reports/html.hpp"
#include "judge/reports/progress_line.hpp"
#include "judge/submission/build.hpp"
#include "judge/submission/compile.hpp"
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

/// A lab as it was measured last.
struct LabData {
  Lab lab;
  std::string program = {};  ///< the path of what was measured: each build has its own
  std::string failure = {};  ///< why the file that is there now has no program, in a line
  std::map<std::string, std::string> records = {};  ///< JSON texts by file name
  std::set<std::string> missing = {};               ///< why tasks have no records
};
using Demo = std::vector<LabData>;

/// Measures a lab if its program is new; without a program, the records stay. Returns whether
/// anything has changed.
bool measure(const Layout& layout, const Submission& submission, const std::atomic<bool>& stop,
             LabData& data) {
  const BuildResult built = build_program(layout, data.lab, submission);
  const auto second = built.failure.find('\n', built.failure.find('\n') + 1);
  std::string failure =
      sandbox::shortened(with_replacements(built.failure.substr(0, second), {{"\n", " "}}), 240);
  const bool is_news = failure != data.failure;
  data.failure = std::move(failure);
  if (!built.program || built.program->path == data.program) return is_news;
  const ScratchDirectory scratch(layout);
  run_hidden_cases(layout, data.lab, CaseKind::measurements, *built.program, tag,
                   {.environment = {{protocol::plot_data_variable, scratch.path().string()}},
                    .wall_seconds = 600,
                    .stop = &stop});
  if (stop) return is_news;
  data.program = built.program->path;
  data.records.clear();
  for (const auto& entry : fs::directory_iterator(scratch.path())) {
    if (entry.path().extension() != ".json") continue;
    std::string text = read_text(entry.path());
    if (!text.empty()) data.records[entry.path().filename().string()] = std::move(text);
  }
  data.missing = missing_in(scratch.path());
  return true;
}

/// Measures each lab whose program is new, the one saved last first; calls `show` after each.
void update(const Layout& layout, const Submission& submission, const std::atomic<bool>& stop,
            Demo& demo, const std::function<void()>& show) {
  const auto saved = [&](const LabData* data) {
    std::error_code none;
    const auto file = submission.files.find(data->lab.name);
    return file == submission.files.end() ? fs::file_time_type::min()
                                          : fs::last_write_time(file->second, none);
  };
  std::vector<LabData*> order;
  for (LabData& data : demo) order.push_back(&data);
  std::ranges::stable_sort(order, std::greater(), saved);
  for (LabData* data : order) {
    if (stop) return;
    if (measure(layout, submission, stop, *data)) show();
  }
}

std::vector<std::string> remarks_of(const Demo& demo) {
  std::vector<std::string> remarks;
  for (const LabData& data : demo) {
    const auto add = [&](const auto& why) {
      remarks.push_back(fmt::format("lab {}: {}", data.lab.number, why));
    };
    if (!data.failure.empty()) add(data.failure);
    std::ranges::for_each(data.missing, add);
  }
  return remarks;
}

std::string list_of(const std::vector<std::string>& remarks) {
  if (remarks.empty()) return {};
  std::string all = "<h2>Not measured</h2>\n<ul>\n";
  for (const std::string& remark : remarks) all += "<li>" + html_escaped(remark) + "</li>\n";
  return all + "</ul>";
}

/// A JSON list; "[]" if nothing is measured.
std::string records_of(const Demo& demo) {
  std::string all;
  for (const LabData& data : demo) {
    for (const auto& [name, text] : data.records) all += (all.empty() ? "" : ",\n") + text;
  }
  return '[' + all + ']';
}

/// A page that needs no other file, of these scripts.
std::string page_of(const Layout& layout, const std::string& label, const Demo& demo,
                    const std::vector<std::string>& scripts) {
  const fs::path pictures = layout.root / "autograder/judge/pictures";
  std::string script, page = read_whole_text(pictures / "demo.html");
  for (const std::string& name : scripts) script += read_whole_text(pictures / name);
  const std::pair<const char*, std::string> parts[] = {
      {"SCRIPT", script},
      {"REMARKS", list_of(remarks_of(demo))},
      {"SUBMISSION", html_escaped(sandbox::printable_line(label))},
      {"VERSION", html_escaped(layout.version)},
      {"DATA", records_of(demo)}};
  for (const auto& [name, text] : parts) {
    page = with_replacements(page, {{fmt::format("<!--{}-->", name), text}});
  }
  return page;
}

/// Measures after each save, for an open page that reads its data from files next to it
/// (demo_watch.js).
int watch_demo(const Layout& layout, const Submission& submission, const fs::path& out,
               Demo& demo) {
  const auto publish = [&](const std::string& news) {
    const auto quoted = [](const std::string& text) {
      return nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    };
    const auto next_to = [&](const char* name) {
      return fmt::format("{}.{}.js", out.string(), name);
    };
    write_text(
        out, page_of(layout, submission.label, demo, {"demo.js", "demo_labs.js", "demo_watch.js"}));
    write_text(next_to("data"), fmt::format("receive({}, {}, {});\n", records_of(demo),
                                            quoted(list_of(remarks_of(demo))), quoted(news)));
    const auto now = std::chrono::system_clock::now().time_since_epoch().count();
    write_text(next_to("version"), fmt::format("follow({});\n", now));
  };
  const auto publish_state = [&] {
    std::set<std::string> failures;  // one file may be part of several labs
    for (const LabData& data : demo) {
      if (!data.failure.empty()) failures.insert(data.failure);
    }
    publish(failures.empty() ? ""
                             : fmt::format("{}; the figures show the last version that compiled.",
                                           fmt::join(failures, "; ")));
  };
  const std::string shown = sandbox::printable_line(out.string());
  const Job job = [&](const std::atomic<bool>& stop) {
    update(layout, submission, stop, demo, publish_state);
    if (!stop) precompile_headers(layout);  // speeds up what is compiled later
    return fmt::format("{}\n{}\n", shown, fmt::join(remarks_of(demo), "\n"));
  };
  WatchedWork work{.jobs = [&] { return std::vector{job}; },
                   .subject = submission.label,
                   .doing = "measuring",
                   .done = "measured"};
  for (const auto& [lab, file] : submission.files) work.files.push_back(file);
  publish("Measuring …");
  fmt::print("{}\n", shown);
  const int status = watch(work);
  publish("This page does not follow the files any more: ./lab demo --watch has ended.");
  return status;
}

int demo(const Context& context, const Arguments& arguments) {
  const Layout& layout = context.layout;
  const fs::path out = arguments.output("out").value_or(layout.build / "demo.html");
  const bool has_solutions = fs::exists(layout.solutions());
  const auto given = arguments.get("dir");
  const fs::path directory = given.value_or(has_solutions ? layout.solutions() : layout.starter());
  Submission submission = open_submission(context.labs, directory);
  if (!given) submission.label = has_solutions ? "the solutions" : "starter";
  Demo demo;
  for (const Lab& lab : labs_in_demo(context)) demo.push_back({lab});
  if (arguments.has("watch")) return watch_demo(layout, submission, out, demo);
  {
    const ProgressLine line("measuring");
    update(layout, submission, false, demo, [] {});
  }
  for (const std::string& remark : remarks_of(demo)) fmt::print("{}\n", remark);
  if (records_of(demo) == "[]") {
    fmt::print("no page: none of the tasks that it shows is written yet\n");
    return 1;
  }
  write_text(out, page_of(layout, submission.label, demo, {"demo.js", "demo_labs.js"}));
  fmt::print("{}\n", sandbox::printable_line(out.string()));
  return 0;
}

const RegisterCommand demo_command{
    {.usage = "demo [--out F.html] [--dir DIR] [--watch]",
     .about = "make a page with an interactive figure for each lab, from your own points",
     .details = "One self-contained page with an interactive figure per lab: digits, error bars, "
                "strata, spectra, elementary intervals, pictures. Measures the solutions if the "
                "checkout has them, otherwise starter/.",
     .options = {{"--out F.html", "the file (build/demo.html)"},
                 {"--dir DIR", "measure this submission instead"},
                 {"--watch",
                  "after each save, measure that lab again and update the open page; "
                  "Ctrl-C ends"}},
     .run = demo,
     .most_words = 0,
     .place = "autograder/judge/pictures/demo.html",
     .targets = [](const Context& context, const Arguments&) {
       return targets_of_all(context, "measure_");
     }}};

}  // namespace
}  // namespace mc::grader
