#include "classes/page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "judge/base/text_file.hpp"
#include "judge/reports/csv.hpp"

namespace mc::grader {
namespace fs = std::filesystem;
namespace {

/// A task of the table: what each student has in it.
struct TaskColumn {
  std::string task;
  double points = 0;
  std::size_t attempted = 0, passed = 0;
};

struct LabGroup {
  Lab lab;
  double points = 0;
  std::vector<TaskColumn> tasks;
};

const LabVerdict* lab_in(const Verdict& verdict, const std::string& name) {
  const auto found = std::ranges::find_if(
      verdict.labs, [&](const LabVerdict& lab) { return lab.lab.name == name; });
  const bool has_points = verdict.not_judged.empty() && verdict.unreadable.empty();
  return found == verdict.labs.end() || !has_points ? nullptr : &*found;
}

/// The points in a task, if it was attempted.
struct InTask {
  double earned = 0, points = 0;
  bool is_attempted = false, is_passed = true;
};
InTask in_task(const LabVerdict& lab, const std::string& task) {
  InTask all;
  for (const CheckResult& result : lab.checks) {
    if (result.check.task != task) continue;
    all.earned += result.earned();
    all.points += result.check.points;
    all.is_passed = all.is_passed && result.status == Status::passed;
    all.is_attempted =
        all.is_attempted || (lab.no_program.empty() && result.status != Status::not_written);
  }
  return all;
}

std::vector<LabGroup> groups_of(const std::vector<Verdict>& verdicts) {
  std::vector<LabGroup> groups;
  for (const Verdict& verdict : verdicts) {
    for (const LabVerdict& lab : verdict.labs) {
      auto group = std::ranges::find_if(
          groups, [&](const LabGroup& one) { return one.lab.name == lab.lab.name; });
      if (group == groups.end()) {
        groups.push_back({lab.lab, lab.points(), {}});
        group = groups.end() - 1;
        for (const CheckResult& result : lab.checks) {
          auto& tasks = group->tasks;
          if (tasks.empty() || tasks.back().task != result.check.task) {
            tasks.push_back({result.check.task});
          }
          tasks.back().points += result.check.points;
        }
      }
      if (lab_in(verdict, lab.lab.name) == nullptr) continue;
      for (TaskColumn& task : group->tasks) {
        const InTask in = in_task(lab, task.task);
        task.attempted += in.is_attempted ? 1 : 0;
        task.passed += in.is_passed ? 1 : 0;
      }
    }
  }
  std::ranges::sort(groups, {}, [](const LabGroup& one) { return one.lab.number; });
  return groups;
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

constexpr const char* pages_folder = "submissions";

std::string student_row(const Verdict& verdict, const std::vector<LabGroup>& groups) {
  std::string all =
      fmt::format("<tr><th scope=\"row\" class=\"name\"><a href=\"{}/{}\">{}</a>", pages_folder,
                  address_of(verdict.submission + ".html"), html_escaped(verdict.submission));
  if (const std::string reason = reason_of(verdict); !reason.empty()) {
    all += "<br><span class=\"quiet\">" + html_escaped(reason) + "</span>";
  }
  all += "</th>";
  for (const LabGroup& group : groups) {
    const LabVerdict* const lab = lab_in(verdict, group.lab.name);
    all += lab == nullptr
               ? "<td></td>"
               : fmt::format("<td class=\"number\"><strong>{:g}</strong></td>", lab->earned());
    for (const TaskColumn& task : group.tasks) {
      const InTask in = lab == nullptr ? InTask() : in_task(*lab, task.task);
      if (!in.is_attempted) {
        all += "<td></td>";
        continue;
      }
      const double share = in.points > 0 ? in.earned / in.points : in.is_passed ? 1 : 0;
      all += fmt::format("<td class=\"number\" style=\"background:rgba(0,114,178,{:.2f})\">{}</td>",
                         0.4 * std::clamp(share, 0.0, 1.0),
                         in.points > 0  ? fmt::format("{:g}", in.earned)
                         : in.is_passed ? "✓"
                                        : "✗");
    }
  }
  return all + "</tr>\n";
}

template <class Cell>
std::string summary_row(const char* name, const std::vector<LabGroup>& groups, Cell cell) {
  std::string all = fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>", name);
  for (const LabGroup& group : groups) {
    all += "<td></td>";
    for (const TaskColumn& task : group.tasks) {
      all += fmt::format("<td class=\"number\">{}</td>", cell(task));
    }
  }
  return all + "</tr>\n";
}

std::string index_page(const std::vector<Verdict>& verdicts) {
  const auto groups = groups_of(verdicts);
  std::string labs = "<tr><td></td>",
              tasks = "<tr><th scope=\"col\" class=\"name\">submission</th>";
  for (const LabGroup& group : groups) {
    labs += fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>", group.tasks.size() + 1,
                        html_escaped(group.lab.title()));
    tasks += fmt::format("<th scope=\"col\" class=\"number\">of {:g}</th>", group.points);
    for (const TaskColumn& task : group.tasks) {
      tasks += fmt::format(
          "<th scope=\"col\" class=\"number\">{}<br><span class=\"quiet\">{}</span></th>",
          task.task, task.points > 0 ? fmt::format("{:g}", task.points) : "stretch");
    }
  }
  std::string all = fmt::format(
      "<h1>Grades</h1>\n<p>{} submissions. The darker a cell, the larger its part of the task's "
      "points; an empty one was not attempted.</p>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"points\"><table>\n{}</tr>\n"
      "{}</tr>\n",
      verdicts.size(), labs, tasks);
  all += summary_row("attempted", groups, [](const TaskColumn& task) { return task.attempted; });
  all += summary_row("passed", groups, [](const TaskColumn& task) { return task.passed; });
  for (const Verdict& verdict : verdicts) all += student_row(verdict, groups);
  return html_page("Grades", all + "</table></div>\n");
}

}  // namespace

void write_class_pages(const fs::path& directory, const std::vector<Verdict>& verdicts,
                       const std::function<Pictures(std::size_t verdict)>& pictures_of) {
  fs::create_directories(directory / pages_folder);
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    write_text(directory / pages_folder / (verdicts[i].submission + ".html"),
               submission_page(verdicts[i], pictures_of(i)));
  }
  write_text(directory / "index.html", index_page(verdicts));
}

}  // namespace mc::grader
