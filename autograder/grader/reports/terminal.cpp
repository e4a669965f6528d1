#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "grader/reports/report.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

constexpr const char* green = "\x1b[32m";
constexpr const char* red = "\x1b[31m";
constexpr const char* grey = "\x1b[2m";
constexpr const char* bold = "\x1b[1m";

std::string painted(const Terminal& terminal, const char* color, const std::string& text) {
  return terminal.color ? color + text + "\x1b[0m" : text;
}

/// "measured  x = 1" with its lines wrapped under the second column.
std::string report_line(std::string_view line, std::size_t margin, std::size_t width) {
  constexpr std::size_t label = 10;
  const std::size_t inner = std::max<std::size_t>(width, margin + label + 20) - margin - label;
  const std::string blank(margin, ' ');
  if (line.size() > label && line.substr(0, label).find("  ") != std::string_view::npos) {
    return blank + std::string(line.substr(0, label)) +
           wrapped(line.substr(label), inner, margin + label) + '\n';
  }
  return blank + std::string(line) + '\n';  // another shape: a compiler's line, unchanged
}

constexpr std::size_t margin = 9;

std::string check_line(const std::string& name, const Terminal& terminal, const char* color,
                       const char* mark, const std::string& right) {
  const std::size_t room = terminal.width > 24 ? terminal.width - 14 : 10;
  std::string text = wrapped(name, room - 9, margin);
  const auto last = text.rfind('\n');
  const std::size_t used =
      last == std::string::npos ? 4 + columns_of(text) : columns_of(text.substr(last + 1));
  const std::size_t gap =
      used + 1 + right.size() < terminal.width ? terminal.width - used - right.size() : 1;
  return fmt::format("  {} {}{}{}\n", painted(terminal, color, mark), text,
                     std::string(gap > 0 ? gap : 1, ' '), right);
}

std::string printed_lines(const std::string& printed) {
  constexpr std::size_t most = 8;
  const auto lines = text::split(printed, '\n');
  std::string all;
  std::size_t count = 0;
  for (const std::string_view line : lines) {
    if (line.empty()) continue;
    if (count++ < most)
      all += fmt::format("{:{}}| {}\n", "", margin, sandbox::shortened(line, 160));
  }
  if (count > most) all += fmt::format("{:{}}| … {} more lines\n", "", margin, count - most);
  return all.empty() ? all : fmt::format("{:{}}it printed\n{}", "", margin, all);
}

std::string points_of(double earned, double points) {
  return fmt::format("{:g}/{:g}", earned, points);
}

/// Of checks; a stretch has no points.
std::string points_or_stretch(double earned, double points) {
  return points > 0 ? points_of(earned, points) : "stretch";
}

std::string points_in_all(const Terminal& terminal, const LabVerdict& lab) {
  return painted(terminal, bold, fmt::format("{:g} of {:g}", lab.earned(), lab.points()));
}

/// "lab 3", or "task 1.4"
std::string called(const std::string& need) {
  return (need.find('.') == std::string::npos ? "lab " : "task ") + need;
}

/// The task or lab that must be right first, if it is in another lab.
std::string roots_elsewhere(const LabVerdict& lab) {
  std::string all;
  for (const std::string& need : lab.unfinished) {
    const auto dot = need.find('.');
    all += fmt::format(
        "  First: {} is not right yet, and checks below depend on it: ./lab check {}\n",
        called(need), dot == std::string::npos ? need : need.substr(0, dot) + " --only " + need);
  }
  return all.empty() ? all : all + '\n';
}

/// The full report of a failure.
std::string full_report(const LabVerdict& lab, const CheckResult& result,
                        const Terminal& terminal) {
  std::string all;
  const auto add = [&](std::string_view line) { all += report_line(line, margin, terminal.width); };
  for (const std::string_view line : text::split(result.report, '\n')) add(line);
  add(fmt::format("read      labs/{}/README.md, section {}", lab.lab.folder, result.check.task));
  add("again     " + result.repeat);
  if (!result.by_hand.empty()) add("by hand   " + result.by_hand);
  return all;
}

/// The same without the contents of long lists: a call may be long; its result comes at the end.
std::string with_short_lists(std::string_view line) {
  constexpr std::size_t longest = 24;
  std::string all;
  while (!line.empty()) {
    const auto open = line.find('{'), close = line.find('}', open);
    if (close == std::string_view::npos) break;
    const bool is_long = close - open > longest;
    all += line.substr(0, is_long ? open : close + 1);
    if (is_long) all += "{…}";
    line.remove_prefix(close + 1);
  }
  return all.append(line);
}

/// Of a failure whose task has failed before: what was measured, and the diagnosis if it is not one
/// that was shown already. The first hint is the one to follow.
std::string short_report(const CheckResult& result, std::set<std::string>& hints,
                         const Terminal& terminal) {
  constexpr std::string_view measured = "measured  ", likely = "likely    ";
  std::string all;
  for (std::string_view line : text::split(result.report, '\n')) {
    if (all.empty()) {
      if (line.starts_with(measured)) line.remove_prefix(measured.size());
      all += report_line("also      " + sandbox::shortened(with_short_lists(line), 240), margin,
                         terminal.width);
    } else if (line.starts_with(likely) && hints.insert(std::string(line)).second) {
      all += report_line(line, margin, terminal.width);
    }
  }
  return all;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::string all, line;
  for (const std::string_view word : text::split(text, ' ')) {
    if (!line.empty() && columns_of(line) + 1 + columns_of(word) > width) {
      all += line + '\n' + std::string(indent, ' ');
      line.clear();
    }
    line += (line.empty() ? "" : " ") + std::string(word);
  }
  return all + line;
}

/// Columns that a UTF-8 text takes (every code point one; the labs use no others).
std::size_t columns_of(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

Terminal this_terminal() {
  Terminal terminal;
  const char* no_color = std::getenv("NO_COLOR");
  const char* kind = std::getenv("TERM");
  terminal.interactive =
      isatty(STDOUT_FILENO) != 0 && (kind == nullptr || std::strcmp(kind, "dumb") != 0);
  terminal.color = terminal.interactive && (no_color == nullptr || *no_color == '\0');
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    terminal.width = std::clamp<std::size_t>(size.ws_col, 40, 100);
  }
  return terminal;
}

std::string jail_warning(const Verdict& verdict) {
  if (verdict.jail_complete) return {};
  return "WARNING: no seccomp on this machine. The submission ran without the sandbox: trust this "
         "grade\nno more than you trust its author.\n";
}

std::string reference_line(const LabVerdict& lab) {
  if (lab.on_reference.empty()) return {};
  return fmt::format("judged with the reference's {}", fmt::join(lab.on_reference, ", "));
}

std::string not_judged_line(const Verdict& verdict) {
  if (verdict.not_judged.empty()) return {};
  return fmt::format("not judged: {}\n", verdict.not_judged);
}

std::string report_lab(const LabVerdict& lab, const Verdict& verdict, const Terminal& terminal) {
  std::string all = fmt::format("{}  {}, seed {}\n\n", painted(terminal, bold, lab.lab.title()),
                                verdict.submission, verdict.seed);
  if (!verdict.found_in.empty()) all += fmt::format("  found in {}\n\n", verdict.found_in);
  if (!lab.on_reference.empty()) all += fmt::format("  {}\n\n", reference_line(lab));
  if (!lab.no_program.empty()) {
    for (const std::string_view line : text::split(lab.no_program, '\n')) {
      all += fmt::format("  {}\n", line);
    }
    return all + fmt::format("\n  {} points\n", points_in_all(terminal, lab)) +
           jail_warning(verdict);
  }
  all += roots_elsewhere(lab);
  std::set<std::string> explained;  // tasks whose first failure is above
  std::set<std::string> hints;      // shown above
  const CheckResult* next = nullptr;
  const bool is_grade = verdict.not_judged.empty();
  for (std::size_t i = 0; i < lab.checks.size(); ++i) {
    const CheckResult& result = lab.checks[i];
    if (result.status == Status::not_judged) {  // a failing machine affects many checks alike
      std::size_t last = i;
      while (last + 1 < lab.checks.size() && lab.checks[last + 1].status == result.status &&
             lab.checks[last + 1].report == result.report) {
        ++last;
      }
      all += check_line(
          last > i ? fmt::format("{} and {} more", result.check.name, last - i) : result.check.name,
          terminal, grey, "?", "not judged");
      all += report_line("because   " + result.report, margin, terminal.width);
      i = last;
      continue;
    }
    const std::string points =
        is_grade ? points_or_stretch(result.earned(), result.check.points) : std::string();
    if (result.is_open() && next == nullptr) next = &result;
    if (result.status == Status::passed) {
      all += check_line(result.check.name, terminal, green, "✓", points);
      continue;
    }
    if (result.status == Status::failed || result.status == Status::internal_error) {
      all += check_line(result.check.name, terminal, red, "✗", points);
      const bool is_first = explained.insert(result.check.task).second;
      if (is_first || result.status != Status::failed) {
        all += full_report(lab, result, terminal);
        for (const std::string_view line : text::split(result.report, '\n')) {
          hints.insert(std::string(line));
        }
      } else {
        all += short_report(result, hints, terminal);
      }
    } else {
      // Once per task, however many checks it has.
      double together = result.check.points;
      std::size_t last = i;
      while (last + 1 < lab.checks.size() && lab.checks[last + 1].check.task == result.check.task &&
             lab.checks[last + 1].status == result.status) {
        together += lab.checks[++last].check.points;
      }
      const std::string what = last > i
                                   ? fmt::format("{} ({} checks)", result.check.task, last - i + 1)
                                   : result.check.name;
      all += check_line(what + ": " + describe(result, lab), terminal, grey, "·",
                        is_grade ? points_or_stretch(0, together) : std::string());
      if (result.status == Status::not_run) {
        all += report_line("because   " + result.report, margin, terminal.width);
      }
      i = last;
    }
    all += printed_lines(result.printed);
  }
  if (!lab.speed.empty()) all += "\n" + report_speed(lab);
  if (!is_grade) return all + "\n  not judged: this is not a zero\n" + jail_warning(verdict);
  all += fmt::format("\n  {} points", points_in_all(terminal, lab));
  if (next != nullptr) {
    all += fmt::format("; next: {}", next->check.task);
  } else if (!lab.unfinished.empty()) {
    all += fmt::format("; next: {}", called(lab.unfinished[0]));
  }
  return all + "\n" + jail_warning(verdict);
}

std::string report_speed(const LabVerdict& lab) {
  std::string all;
  const auto line = [&](const std::string& name, const auto& print, double value,
                        const std::optional<double>& reference = {}, const char* about = "") {
    all += fmt::format("  {:<36}{:>14}", name, print(value));
    all += reference ? fmt::format("   (the reference: {}{})\n", about, print(*reference)) : "\n";
  };
  const auto nanoseconds = [](double value) {
    return value < 1000 ? fmt::format("{:.3g} ns", value) : fmt::format("{:.0f} ns", value);
  };
  const auto digits = [](double value) { return fmt::format("{:.2g}", value); };
  for (const Speed& one : lab.speed) {
    line(one.name, nanoseconds, one.nanoseconds, one.reference, one.is_estimate ? "about " : "");
    if (!one.error) continue;
    line(fmt::format("    error of {} on {}", one.points, one.integrand), digits, *one.error,
         one.reference_error);
  }
  double addition = 0;
  bool is_estimate = false;
  for (const Speed& one : lab.speed) {
    addition = std::max(addition, one.addition);
    is_estimate = is_estimate || one.is_estimate;
  }
  if (addition > 0) line("a running sum, to compare", nanoseconds, addition);
  if (const auto times = lab.times_the_reference()) {
    const bool is_slow = *times < 0.5;
    const double ratio = is_slow ? 1 / *times : *times;
    all += fmt::format("  {}{} the reference; speed is not graded.\n",
                       is_estimate || ratio >= 10
                           ? fmt::format("about {:.{}f} times", ratio, ratio < 10 ? 1 : 0)
                           : fmt::format("{:.2f} times", ratio),
                       is_slow ? " slower than" : " as fast as");
  }
  return all;
}

std::string report_summary(const std::vector<Verdict>& verdicts, std::size_t columns) {
  std::size_t widest = columns;
  for (const Verdict& verdict : verdicts) {
    widest = std::max(widest, columns_of(verdict.submission));
  }
  std::string all;
  for (const Verdict& verdict : verdicts) {
    all += verdict.submission + std::string(widest - columns_of(verdict.submission), ' ');
    const std::string& why = verdict.unreadable.empty() ? verdict.not_judged : verdict.unreadable;
    if (!why.empty()) {
      all += fmt::format("  {}: {}\n", verdict.unreadable.empty() ? "not judged" : "unreadable",
                         why.substr(0, why.find('\n')));
      continue;
    }
    all += fmt::format("  {:>9}", points_of(verdict.earned(), verdict.points()));
    for (const LabVerdict& lab : verdict.labs) {
      const auto& absent = verdict.absent;
      const bool is_absent = std::find(absent.begin(), absent.end(), lab.lab.name) != absent.end();
      all += fmt::format("  {} {}", lab.lab.name,
                         is_absent                ? "no file"
                         : lab.no_program.empty() ? points_of(lab.earned(), lab.points())
                                                  : "no program");
    }
    if (verdict.labs.empty()) all += "  it contains no lab files";
    if (!verdict.found_in.empty()) all += fmt::format("  found in {}", verdict.found_in);
    all += '\n';
  }
  return all;
}

}  // namespace mc::grader
