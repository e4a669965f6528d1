#include "grader/gradebook/class_page.hpp"

#include <algorithm>

#include "grader/reports/html.hpp"
#include "grader/submission/source.hpp"

namespace mc::grader {
namespace {

/// A table that scrolls; its first column names the rows.
std::string table_begin(const std::vector<std::string>& numbers, const std::string& first,
                        const std::string& label) {
  std::string all =
      scrolling(label) +
      fmt::format("<table>\n<tr><th scope=\"col\" class=\"name\">{}</th>", html_escaped(first));
  for (const std::string& number : numbers) {
    all += fmt::format("<th scope=\"col\" class=\"number\">{}</th>", html_escaped(number));
  }
  return all + "</tr>\n";
}
constexpr const char* table_end = "</table></div>\n";

std::string number_cell(const std::string& text) {
  return fmt::format("<td class=\"number\">{}</td>", html_escaped(text));
}
std::string number_cell(std::size_t count) {
  return number_cell(std::to_string(count));
}
/// `name` is already HTML.
std::string name_cell(const std::string& name) {
  return fmt::format("<th scope=\"row\" class=\"name\">{}</th>", name);
}

std::string histogram(const LabStatistics& lab) {
  const auto bars = histogram_of(lab.totals, lab.points);
  std::size_t most = 1;
  for (const PointsBar& bar : bars) most = std::max(most, bar.submissions);
  std::string all =
      "<table>\n<tr><th scope=\"col\" class=\"number\">points</th><th scope=\"col\" "
      "class=\"number\">submissions"
      "</th><td></td></tr>\n";
  for (const PointsBar& bar : bars) {  // the number next to it gives the bar's value
    all += fmt::format(
        "<tr><th scope=\"row\" class=\"number\">{}</th>{}<td class=\"wide\"><span class=\"bar\" "
        "aria-hidden=\"true\" "
        "style=\"width:{:.1f}%\"></span></td></tr>\n",
        html_escaped(bar.range), number_cell(bar.submissions),
        100.0 * static_cast<double>(bar.submissions) / static_cast<double>(most));
  }
  return all + "</table>\n";
}

std::string lab_section(const LabStatistics& lab) {
  const std::string title = lab.lab.title();
  std::string all =
      fmt::format("<h2>{}</h2>\n<p>{}</p>\n<h3>Points</h3>\n{}<h3>Tasks</h3>\n",
                  html_escaped(title), fmt::join(summary_of(lab), "<br>"), histogram(lab));
  all += table_begin({"points earned", "attempts with all points"}, "task", title + ": tasks");
  for (const TaskStatistics& one : lab.tasks) {
    all += "<tr>" + name_cell(one.task) + number_cell(fmt::format("{:.0f} %", 100 * one.share)) +
           number_cell(one.complete) + "</tr>\n";
  }
  all += std::string(table_end) + "<h3>Checks</h3>\n" +
         table_begin({"passed", "wrong", "waiting", "withheld", "not written", "discrimination"},
                     "check", title + ": checks");
  for (const CheckStatistics& one : lab.checks) {
    all += "<tr>" + name_cell(html_escaped(one.name)) + number_cell(one.passed) +
           number_cell(one.wrong) + number_cell(one.waiting) + number_cell(one.withheld) +
           number_cell(one.not_written) +
           number_cell(one.discrimination ? fmt::format("{:.2f}", *one.discrimination) : "-") +
           "</tr>\n";
  }
  return all + table_end;
}

std::string statistics_sections(const ClassStatistics& statistics) {
  std::string all;
  if (statistics.without_verdict > 0) {
    all += fmt::format(
        "<p>{} of {} submissions have no verdict next to the table: their unwritten tasks count "
        "as wrong, and their hints are unknown.</p>\n",
        statistics.without_verdict, statistics.submissions);
  }
  for (const LabStatistics& lab : statistics.labs) all += lab_section(lab);
  if (!statistics.labs.empty()) {
    all +=
        "<p class=\"quiet\">Discrimination is the point-biserial correlation of passing a check "
        "with "
        "the points of the lab's other checks.</p>\n";
  }
  if (statistics.hints.empty()) return all;
  all += "<h2>Hints</h2>\n" + table_begin({"submissions"}, "hint", "hints");
  for (const HintStatistics& one : statistics.hints) {
    all += "<tr>" + name_cell(html_escaped(one.hint)) + number_cell(one.submissions) + "</tr>\n";
  }
  return all + table_end;
}

/// The URL of the file with this name. An id may have any character but a slash.
std::string address_of(const std::string& name) {
  std::string all;
  for (const char c : name) {
    const bool is_plain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                          (c >= 'a' && c <= 'z') || c == '-' || c == '_' || c == '.';
    all += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return all;
}

/// Students × tasks: the share of each task's points, as a number and as a shade.
std::string heat_map(const Table& table, const ClassStatistics& statistics) {
  std::vector<std::string> names;
  for (const LabStatistics& lab : statistics.labs) {
    for (const TaskStatistics& task : lab.tasks) names.push_back(task.task);
  }
  if (names.empty()) return {};
  std::string all = "<h2>Tasks</h2>\n<p class=\"quiet\">Percent of each task's points</p>\n" +
                    table_begin(names, "submission", "submissions and tasks");
  for (const Row& row : table.rows) {
    all += "<tr>" + name_cell(html_escaped(field(row, "id")));
    for (const LabStatistics& lab : statistics.labs) {
      for (const TaskStatistics& task : lab.tasks) {
        const auto earned = task_points_in(table, row, task);
        if (!earned || task.points <= 0) {
          all += "<td></td>";
          continue;
        }
        const double share = *earned / task.points;
        all += fmt::format(
            "<td class=\"number\" style=\"background:rgba(0,114,178,{:.2f})\">{:.0f}</td>",
            0.45 * std::clamp(share, 0.0, 1.0), 100 * share);
      }
    }
    all += "</tr>\n";
  }
  return all + table_end;
}

constexpr const char* pages_folder = "submissions";

/// Shows the rows of both tables of submissions that contain what is searched for, fifty at a time.
/// Without scripts the page shows all of them.
constexpr const char* search = R"html(<p id="search" hidden>
<label>Search <input type="search"></label>
<button type="button">Previous</button> <button type="button">Next</button>
<span role="status"></span></p>
<script>
"use strict";
const bar = document.getElementById("search"), input = bar.querySelector("input");
const [back, next] = bar.querySelectorAll("button"), size = 50;
let first = 0, tables = [];
function show() {
  const word = input.value.toLowerCase(), [ids] = tables;
  const found = ids.map((row, i) => i).filter(i => ids[i].textContent.toLowerCase().includes(word));
  const page = new Set(found.slice(first, first + size));
  for (const rows of tables) rows.forEach((row, i) => { row.hidden = !page.has(i); });
  back.disabled = first === 0;
  next.disabled = first + size >= found.length;
  bar.querySelector("[role=status]").textContent =
    `${found.length && first + 1} to ${first + page.size} of ${found.length}`;
}
function go(to) { first = to; show(); }
onload = () => {
  tables = ["submissions", "submissions and tasks"].map(name =>
    [...document.querySelectorAll(`[aria-label="${name}"] tr`)].slice(1));
  bar.hidden = false;
  input.oninput = () => go(0);
  back.onclick = () => go(first - size);
  next.onclick = () => go(first + size);
  show();
};
</script>
)html";

std::string index_page(const Table& table, const std::map<std::string, Verdict>& verdicts,
                       const ClassStatistics& statistics) {
  std::vector<std::string> labs;
  for (const LabStatistics& lab : statistics.labs) labs.push_back(lab.lab.name);
  std::string all = fmt::format("<h1>Grades</h1>\n<p>{} submissions</p>\n<h2>Submissions</h2>\n",
                                statistics.submissions);
  all += search + table_begin(labs, "submission", "submissions");
  for (const Row& row : table.rows) {
    const std::string id = field(row, "id"), name = html_escaped(id);
    std::string first =
        verdicts.contains(id)
            ? fmt::format("<a href=\"{}/{}\">{}</a>", pages_folder, address_of(id + ".html"), name)
            : name;
    if (!field(row, "late").empty()) first += " <strong>LATE</strong>";
    const std::string reason = field(row, "reason");
    if (!reason.empty()) first += "<br><span class=\"quiet\">" + html_escaped(reason) + "</span>";
    const std::string corrections = field(row, "corrections");
    if (!corrections.empty()) {
      first += "<br><span class=\"quiet\">corrected: " + html_escaped(corrections) + "</span>";
    }
    all += "<tr>" + name_cell(first);
    for (const std::string& lab : labs) {
      const std::string total = field(row, lab + " total"), status = field(row, lab + " status");
      all += number_cell(total.empty()        ? status
                         : status == "judged" ? total
                                              : fmt::format("{} ({})", total, status));
    }
    all += "</tr>\n";
  }
  all += table_end + heat_map(table, statistics);
  return html_page("Grades", all + statistics_sections(statistics));
}

}  // namespace

std::string statistics_page(const ClassStatistics& statistics) {
  return html_page("Statistics",
                   fmt::format("<h1>Statistics of {} submissions</h1>\n", statistics.submissions) +
                       statistics_sections(statistics));
}

void write_class_pages(const fs::path& directory, const Context& context, const Table& table,
                       const std::vector<IntakeEntry>& entries) {
  const auto verdicts = read_verdicts(table);
  fs::create_directories(directory / pages_folder);
  for (const IntakeEntry& one : entries) {
    const auto verdict = verdicts.find(one.submission.label);
    if (verdict == verdicts.end()) continue;
    PageMaterial material;
    for (const Row& row : table.rows) {
      if (field(row, "id") != one.submission.label) continue;
      material.corrections = field(row, "corrections");
    }
    for (const LabVerdict& lab : verdict->second.labs) {
      const auto file = one.submission.files.find(lab.lab.name);
      if (file != one.submission.files.end()) {
        material.sources[lab.lab.name] = read_source(file->second).text;
      }
    }
    write_text(directory / pages_folder / (one.submission.label + ".html"),
               submission_page(verdict->second, material));
  }
  write_text(directory / "index.html",
             index_page(table, verdicts, statistics_of(table, verdicts, context.labs)));
}

}  // namespace mc::grader
