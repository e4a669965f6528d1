#include "grader/reports/html.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "grader/base/replace.hpp"
#include "grader/base/text_file.hpp"
#include "grader/judging/repeat_commands.hpp"
#include "grader/reports/report.hpp"
#include "runner/text.hpp"

namespace mc::grader {
namespace {

/// Colors have a contrast of at least 4.5:1 on both backgrounds; a word and a mark show the status,
/// never color alone.
constexpr const char* style = R"css(
:root { color-scheme: light dark; --ink: #1b1b1b; --ground: #fff; --soft: #f2f2f0; --line: #c9c9c5;
  --good: #00664f; --bad: #a63a00; --quiet: #5c5c5c; --bar: #0072b2; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e6; --ground: #161616; --soft: #232322;
  --line: #4a4a48; --good: #4fc3a1; --bad: #ff9d66; --quiet: #a8a8a4; --bar: #56b4e9; } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 62rem; padding: 1rem; color: var(--ink);
  background: var(--ground); font: 1rem/1.5 system-ui, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.2rem; margin-top: 2rem; } h3 { font-size: 1rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: .25rem .5rem;
  border-bottom: 1px solid var(--line); }
td.number, th.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
pre { background: var(--soft); padding: .6rem; margin: .4rem 0;
  white-space: pre-wrap; font-size: .85rem; }
details > summary { cursor: pointer; }
span.passed, span.failed { white-space: nowrap; }
.passed { color: var(--good); } .failed { color: var(--bad); }
.other, .quiet { color: var(--quiet); }
ol.code { background: var(--soft); padding: .6rem .6rem .6rem 3.6rem; margin: .4rem 0;
  font: .8rem/1.4 ui-monospace, monospace; }
ol.code li { white-space: pre-wrap; } ol.code .message { color: var(--bad); font-weight: 600; }
th[scope=row] { font-weight: normal; } th.name { min-width: 11rem; } td.wide { width: 100%; }
.bar { display: inline-block; height: .7rem; background: var(--bar); vertical-align: middle; }
img { width: 100%; height: auto; }
.scroll { overflow-x: auto; } [hidden] { display: none; }
input, button { font: inherit; max-width: 100%; }
)css";

std::string points_cell(double earned, double points) {
  return points > 0 ? fmt::format("<td class=\"number\">{:g} of {:g}</td>", earned, points)
                    : "<td class=\"number\">stretch</td>";
}

/// The messages of a compilation, "variance.cpp:12:5: error: …", by their lines.
std::multimap<std::size_t, std::string> messages_of(const LabVerdict& lab) {
  std::multimap<std::size_t, std::string> messages;
  const std::string file = lab.lab.file();
  for (const std::string_view line : text::split(lab.no_program, '\n')) {
    if (!line.starts_with(file + ':')) continue;
    const std::size_t row = std::strtoul(line.data() + file.size() + 1, nullptr, 10);
    const auto colon = line.find(": ", file.size());
    if (row > 0 && colon != std::string_view::npos) messages.emplace(row, line.substr(colon + 2));
  }
  return messages;
}

/// The file with its line numbers, and the compiler's messages under the lines they are about.
std::string code(const std::string& source, const LabVerdict& lab) {
  const auto messages = messages_of(lab);
  std::string list = "<ol class=\"code\">\n";
  std::size_t row = 0;
  std::istringstream lines(source);
  for (std::string line; std::getline(lines, line);) {
    list += "<li>" + html_escaped(line);
    const auto [first, last] = messages.equal_range(++row);
    for (auto message = first; message != last; ++message) {
      list += fmt::format("\n<span class=\"message\">↑ {}</span>", html_escaped(message->second));
    }
    list += "</li>\n";
  }
  list += "</ol>\n";
  const std::string name = html_escaped(lab.lab.file());
  return messages.empty() ? fmt::format("<details><summary>{}, {} lines</summary>\n{}</details>\n",
                                        name, row, list)
                          : fmt::format("<h3>{}</h3>\n{}", name, list);
}

std::string mark_of(const CheckResult& result, const LabVerdict& lab) {
  if (result.status == Status::passed) return "<span class=\"passed\">✓ passed</span>";
  if (result.status == Status::failed) return "<span class=\"failed\">✗ failed</span>";
  return fmt::format("<span class=\"other\">{}</span>", html_escaped(describe(result, lab)));
}

std::string check_row(const CheckResult& result, const LabVerdict& lab, std::uint64_t seed) {
  std::string what = html_escaped(result.check.name), report = result.report;
  if (result.status == Status::failed) {
    report = failure_report(lab, result, own_repeat_command(lab.lab, result.check, seed));
  }
  if (!report.empty() && result.status != Status::not_written && result.status != Status::waiting) {
    what += "<pre>" + html_escaped(report) + "</pre>";
  }
  if (!result.printed.empty()) {
    what += "<details><summary>it printed</summary><pre>" +
            html_escaped(result.printed.substr(0, 4000)) + "</pre></details>";
  }
  return fmt::format("<tr><td>{}</td><td>{}</td>{}</tr>\n", mark_of(result, lab), what,
                     points_cell(result.earned(), result.check.points));
}

std::string speed_table(const LabVerdict& lab) {
  if (lab.speed.empty()) return {};
  const bool has_errors =
      std::ranges::any_of(lab.speed, [](const Speed& one) { return one.error.has_value(); });
  const auto header = [](const char* text) {
    return fmt::format("<th scope=\"col\" class=\"number\">{}</th>", text);
  };
  const auto cell = [](const std::optional<double>& value) {
    return value ? fmt::format("<td class=\"number\">{:.3g}</td>", *value)
                 : std::string("<td class=\"number\">not measured</td>");
  };
  std::string all = "<h3>Speed (not graded)</h3>\n" + scrolling("speed of " + lab.lab.name) +
                    "<table>\n<tr><th scope=\"col\">task</th>" + header("ns each") +
                    header("plain code") + (has_errors ? header("RMSE") : "") + "</tr>\n";
  for (const Speed& one : lab.speed) {
    all += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>{}{}{}</tr>\n",
                       html_escaped(one.name), cell(one.nanoseconds), cell(one.plain),
                       has_errors ? cell(one.error) : "");
  }
  return all + "</table></div>\n";
}

std::string pictures_of(const std::vector<std::filesystem::path>& files) {
  std::string all;
  for (const auto& file : files) {
    const std::string svg = with_replacements(  // % first: the others insert it
        read_text(file), {{"%", "%25"}, {"#", "%23"}, {"\n", "%0A"}, {"\t", "%09"}});
    all += fmt::format(
        "<figure><img alt=\"plot {0}\" src=\"data:image/svg+xml,{1}\">"
        "<figcaption class=\"quiet\">{0}</figcaption></figure>\n",
        html_escaped(file.stem().string()), html_escaped(svg));
  }
  return all;
}

template <class Map>
auto found_or_empty(const Map& map, const std::string& key) {
  const auto found = map.find(key);
  return found == map.end() ? typename Map::mapped_type{} : found->second;
}

std::string lab_section(const LabVerdict& lab, std::uint64_t seed, const PageMaterial& material) {
  std::string all = fmt::format("<h2>{}: {:g} of {:g} points</h2>\n", html_escaped(lab.lab.title()),
                                lab.earned(), lab.points());
  if (!lab.on_reference.empty()) all += "<p>" + html_escaped(reference_line(lab)) + "</p>\n";
  if (!lab.no_program.empty()) all += "<pre>" + html_escaped(lab.no_program) + "</pre>\n";
  for (const std::string& need : lab.unfinished) {
    all += fmt::format("<p>First: {} is not right yet, and checks below depend on it.</p>\n",
                       html_escaped(lab_or_task(need)));
  }
  if (lab.no_program.empty()) {
    all +=
        "<table>\n<tr><th scope=\"col\">verdict</th><th scope=\"col\">check</th>"
        "<th scope=\"col\" class=\"number\">points</th></tr>\n";
    for (const CheckResult& result : lab.checks) all += check_row(result, lab, seed);
    all += "</table>\n";
  }
  all += speed_table(lab) + pictures_of(found_or_empty(material.pictures, lab.lab.name));
  const std::string source = found_or_empty(material.sources, lab.lab.name);
  if (!source.empty()) all += code(source, lab);
  return all;
}

}  // namespace

std::string html_escaped(std::string_view text) {
  return with_replacements(  // & first: the others insert it
      text, {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}});
}

std::string scrolling(const std::string& label) {
  return fmt::format("<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">",
                     html_escaped(label));
}

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n"
      "<main>\n{}</main>\n</body>\n</html>\n",
      html_escaped(title), style, body);
}

std::string submission_page(const Verdict& verdict, const PageMaterial& material) {
  std::string body = fmt::format("<h1>{}</h1>\n", html_escaped(verdict.submission));
  if (!verdict.unreadable.empty()) {
    body += "<p class=\"failed\">Unreadable: " + html_escaped(verdict.unreadable) + "</p>\n";
  } else if (!verdict.not_judged.empty()) {
    // The reason may name a path of the grading machine: only the table has it.
    body +=
        "<p class=\"failed\">Not judged: the grading machine failed. This is not a grade.</p>\n";
  } else {
    body += fmt::format("<p><strong>{:g} of {:g} points</strong></p>\n", verdict.earned(),
                        verdict.points());
  }
  body += fmt::format("<p class=\"quiet\">seed {}, version {}</p>\n", verdict.seed,
                      html_escaped(verdict.version));
  if (!verdict.delivery.submitted.empty() || verdict.delivery.late) {
    body +=
        fmt::format("<p class=\"quiet\">submitted {}{}</p>\n",
                    html_escaped(verdict.delivery.submitted), verdict.delivery.late ? " LATE" : "");
  }
  if (const std::string warning = jail_warning(verdict); !warning.empty()) {
    body += "<p class=\"failed\">" + html_escaped(warning) + "</p>\n";
  }
  if (!material.corrections.empty()) {
    body += "<p>Corrected by hand: " + html_escaped(material.corrections) + "</p>\n";
  }
  for (const LabVerdict& lab : verdict.labs) body += lab_section(lab, verdict.seed, material);
  return html_page(verdict.submission, body);
}

}  // namespace mc::grader
