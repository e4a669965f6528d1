#include "judge/reports/html.hpp"

#include <fmt/format.h>

#include "judge/base/replace.hpp"
#include "judge/base/text_file.hpp"
#include "judge/judging/repeat_commands.hpp"
#include "judge/reports/report.hpp"

namespace mc::grader {
namespace {

/// Colors have a contrast of at least 4.5:1 on both backgrounds; a word and a mark show the status,
/// never color alone.
constexpr const char* style = R"css(
:root { color-scheme: light dark; --ink: #1b1b1b; --ground: #fff; --soft: #f2f2f0; --line: #c9c9c5;
  --good: #00664f; --bad: #a63a00; --quiet: #5c5c5c; }
@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e6; --ground: #161616; --soft: #232322;
  --line: #4a4a48; --good: #4fc3a1; --bad: #ff9d66; --quiet: #a8a8a4; } }
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
span.passed, span.failed { white-space: nowrap; }
.passed { color: var(--good); } .failed { color: var(--bad); }
.other, .quiet { color: var(--quiet); }
th[scope=row] { font-weight: normal; } th.name { min-width: 9rem; }
.scroll { overflow-x: auto; }
.scroll th.name { position: sticky; left: 0; background: var(--ground); }
img { width: 100%; height: auto; }
)css";

std::string points_cell(double earned, double points) {
  return points > 0 ? fmt::format("<td class=\"number\">{:g} of {:g}</td>", earned, points)
                    : "<td class=\"number\">stretch</td>";
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

std::string lab_section(const LabVerdict& lab, std::uint64_t seed, const Pictures& pictures) {
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
  const auto drawn = pictures.find(lab.lab.name);
  return drawn == pictures.end() ? all : all + pictures_of(drawn->second);
}

}  // namespace

std::string html_escaped(std::string_view text) {
  return with_replacements(  // & first: the others insert it
      text, {{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}});
}

std::string html_page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n"
      "<main>\n{}</main>\n</body>\n</html>\n",
      html_escaped(title), style, body);
}

std::string submission_page(const Verdict& verdict, const Pictures& pictures) {
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
  if (const std::string warning = jail_warning(verdict); !warning.empty()) {
    body += "<p class=\"failed\">" + html_escaped(warning) + "</p>\n";
  }
  if (!verdict.found_in.empty()) {
    body += "<p class=\"quiet\">found in " + html_escaped(verdict.found_in) + "</p>\n";
  }
  for (const LabVerdict& lab : verdict.labs) body += lab_section(lab, verdict.seed, pictures);
  return html_page(verdict.submission, body);
}

}  // namespace mc::grader
