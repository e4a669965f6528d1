#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/reports/report.hpp"
#include "runner/text.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

constexpr const char *green = "\x1b[32m", *red = "\x1b[31m", *grey = "\x1b[2m", *bold = "\x1b[1m";

/// Is a report due, of the submission or of the autograder?
bool is_fault(const CheckResult& result) {
  return result.status == Status::failed || result.status == Status::internal_error;
}

std::string painted(const Terminal& terminal, const char* color, const std::string& text) {
  return terminal.color ? color + text + "\x1b[0m" : text;
}

constexpr std::size_t margin = 9;

/// "measured  x = 1" with its lines wrapped under the second column.
std::string report_line(std::string_view line, const Terminal& terminal) {
  constexpr std::size_t label = 10, indent = margin + label;
  const std::size_t width = std::max(terminal.width, indent + 20) - indent;
  const bool has_label =
      line.size() > label && line.substr(0, label).find("  ") != std::string_view::npos;
  return fmt::format("{:{}}{}{}\n", "", margin, line.substr(0, has_label ? label : line.size()),
                     has_label ? wrapped(line.substr(label), width, indent) : "");
}

std::string report_lines(std::string_view report, const Terminal& terminal) {
  std::string all;
  for (const std::string_view line : text::split(report, '\n')) all += report_line(line, terminal);
  return all;
}

struct Mark {
  const char *color, *text;
};

Mark mark_of(const CheckResult& result) {
  if (result.status == Status::passed) return {green, "✓"};
  if (is_fault(result)) return {red, "✗"};
  return {grey, result.status == Status::not_judged ? "?" : "·"};
}

/// "  ✓ name                8/8": the mark of a check, its name, and its points at the right.
std::string check_line(const std::string& name, const Terminal& terminal, const Mark& mark,
                       const std::string& right) {
  const std::string text = wrapped(name, std::max<std::size_t>(terminal.width, 24) - 23, margin);
  const auto last = text.rfind('\n');
  const std::size_t used =
      last == std::string::npos ? 4 + columns_of(text) : columns_of(text.substr(last + 1));
  const std::size_t free = terminal.width - std::min(terminal.width, used + right.size());
  return fmt::format("  {} {}{:{}}{}\n", painted(terminal, mark.color, mark.text), text, "",
                     std::max<std::size_t>(free, 1), right);
}

std::string printed_lines(const std::string& printed) {
  constexpr std::size_t most = 8;
  std::string all;
  std::size_t count = 0;
  for (const std::string_view line : text::split(printed, '\n')) {
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

std::string points_in_all(const Terminal& terminal, const LabVerdict& lab) {
  return painted(terminal, bold, fmt::format("{:g} of {:g}", lab.earned(), lab.points()));
}

/// The task or lab that must be right first, if it is in another lab.
std::string roots_elsewhere(const LabVerdict& lab) {
  std::string all;
  for (const std::string& need : lab.unfinished) {
    const auto dot = need.find('.');
    all +=
        fmt::format("  First: {} is not right yet, and checks below depend on it: ./lab check {}\n",
                    lab_or_task(need),
                    dot == std::string::npos ? need : need.substr(0, dot) + " --only " + need);
  }
  return all.empty() ? all : all + '\n';
}

/// The line without the contents of long lists: a call may be long; its result comes at the end.
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
  constexpr std::string_view measured = "measured  ", likely = "likely    ", rule = "rule      ";
  std::string all;
  for (std::string_view line : text::split(result.report, '\n')) {
    if (all.empty()) {
      if (line.starts_with(measured)) line.remove_prefix(measured.size());
      all += report_line("also      " + sandbox::shortened(with_short_lists(line), 240), terminal);
    } else if ((line.starts_with(likely) || line.starts_with(rule)) &&
               hints.insert(std::string(line)).second) {
      all += report_line(line, terminal);
    }
  }
  return all;
}

/// How many of the checks from `first` on share one line: those that the same failure of the
/// machine prevented; of one task, those that are waiting, not written or not run.
std::size_t together_from(const std::vector<CheckResult>& checks, std::size_t first) {
  const CheckResult& one = checks[first];
  if (one.status == Status::passed || is_fault(one)) return 1;
  const auto end = std::find_if_not(
      checks.begin() + static_cast<std::ptrdiff_t>(first), checks.end(), [&](auto& other) {
        return other.status == one.status &&
               (one.status == Status::not_judged ? other.report == one.report
                                                 : other.check.task == one.check.task);
      });
  return static_cast<std::size_t>(end - checks.begin()) - first;
}

/// The line of `count` checks that share a status.
std::string title_of(const CheckResult& first, std::size_t count, const LabVerdict& lab) {
  if (first.status == Status::passed || is_fault(first)) return first.check.name;
  if (first.status == Status::not_judged) {
    return first.check.name + (count > 1 ? fmt::format(" and {} more", count - 1) : "");
  }
  return fmt::format(
      "{}: {}",
      count > 1 ? fmt::format("{} ({} checks)", first.check.task, count) : first.check.name,
      describe(first, lab));
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  const auto words = text::split(text, ' ');
  return text::wrapped({words.begin(), words.end()}, width, indent);
}

bool is_interactive(int descriptor) {
  const char* kind = std::getenv("TERM");
  return isatty(descriptor) != 0 && (kind == nullptr || std::string_view(kind) != "dumb");
}

std::size_t window_columns(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

Terminal this_terminal() {
  Terminal terminal;
  const char* no_color = std::getenv("NO_COLOR");
  terminal.interactive = is_interactive(STDOUT_FILENO);
  terminal.color = terminal.interactive && (no_color == nullptr || *no_color == '\0');
  if (const std::size_t columns = window_columns(STDOUT_FILENO); columns > 0) {
    terminal.width = std::clamp<std::size_t>(columns, 40, 100);
  }
  return terminal;
}

std::string jail_warning(const Verdict& verdict) {
  if (!verdict.reads_confined && verdict.jail_complete) {
    return "WARNING: no Landlock on this machine (Linux 5.13). Compiling could read any file that "
           "the "
           "judge's\nuser can read: trust this grade no more than you trust its author.\n";
  }
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

std::string failure_report(const LabVerdict& lab, const CheckResult& result,
                           const std::string& repeat) {
  std::string all = fmt::format("{}\nread      labs/{}/README.md, section {}\nagain     {}",
                                result.report, lab.lab.folder, result.check.task, repeat);
  if (!result.by_hand.empty()) all += "\nby hand   " + result.by_hand;
  return all;
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
  const auto is_open = [](const CheckResult& result) { return result.is_open(); };
  const auto next = std::ranges::find_if(lab.checks, is_open);
  const bool is_grade = verdict.not_judged.empty();
  for (std::size_t i = 0, count = 0; i < lab.checks.size(); i += count) {
    const CheckResult& result = lab.checks[i];
    count = together_from(lab.checks, i);
    double points = 0;
    for (std::size_t j = i; j < i + count; ++j) points += lab.checks[j].check.points;
    all += check_line(title_of(result, count, lab), terminal, mark_of(result),
                      result.status == Status::not_judged ? "not judged"
                      : !is_grade                         ? ""
                      : points > 0                        ? points_of(result.earned(), points)
                                                          : "stretch");
    if (result.status == Status::not_judged || result.status == Status::not_run) {
      all += report_line("because   " + result.report, terminal);
    } else if (is_fault(result)) {
      const bool is_first = explained.insert(result.check.task).second;
      if (is_first || result.status != Status::failed) {
        all += report_lines(failure_report(lab, result, result.repeat), terminal);
        for (const auto line : text::split(result.report, '\n')) hints.emplace(line);
      } else {
        all += short_report(result, hints, terminal);
      }
    }
    if (result.status != Status::passed && result.status != Status::not_judged) {
      all += printed_lines(result.printed);
    }
  }
  if (!lab.speed.empty()) all += "\n" + report_speed(lab);
  if (!is_grade) return all + "\n  not judged: this is not a zero\n" + jail_warning(verdict);
  all += fmt::format("\n  {} points", points_in_all(terminal, lab));
  if (next != lab.checks.end()) {
    all += fmt::format("; next: {}", next->check.task);
  } else if (!lab.unfinished.empty()) {
    all += fmt::format("; next: {}", lab_or_task(lab.unfinished[0]));
  }
  return all + "\n" + jail_warning(verdict);
}

std::string report_speed(const LabVerdict& lab) {
  std::string all;
  const auto nanoseconds = [](double value) {
    return value < 1000 ? fmt::format("{:.3g} ns", value) : fmt::format("{:.0f} ns", value);
  };
  double noise = 0, compared = 0;
  for (const Speed& one : lab.speed) {
    all += fmt::format("  {:<36}{:>14}", one.name, nanoseconds(one.nanoseconds));
    if (one.plain) all += fmt::format("   (plain code: {})", nanoseconds(*one.plain));
    all += '\n';
    if (one.error) {
      all +=
          fmt::format("  {:<36}{:>14.2g}\n",
                      fmt::format("    RMSE of {} on {}", one.points, one.integrand), *one.error);
    }
    noise = std::max(noise, one.noise);
    compared += one.plain.has_value();
  }
  if (const auto times = lab.times_plain()) {
    const bool is_slow = *times < 1;
    const double factor = is_slow ? 1 / *times : *times;
    all += fmt::format("  {:.{}f} times {} plain code{}, ± {:.0f} %; speed is not graded.\n",
                       factor, factor < 10 ? 1 : 0, is_slow ? "slower than" : "as fast as",
                       compared > 1 ? " (geometric mean)" : "", std::ceil(100 * noise));
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
      const bool is_absent = std::ranges::find(absent, lab.lab.name) != absent.end();
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
