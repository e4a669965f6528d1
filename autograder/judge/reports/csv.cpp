#include "judge/reports/csv.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "judge/base/replace.hpp"
#include "sandbox/printable.hpp"

namespace mc::grader {
namespace {

/// Spreadsheets read text with such a beginning as a formula; some also full-width signs (＝ ＋ － ＠).
bool begins_formula(std::string_view text) {
  if (text.empty()) return false;
  if (std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos) return true;
  for (const std::string_view wide : {"＝", "＋", "－", "＠"}) {
    if (text.starts_with(wide)) return true;
  }
  return false;
}

const LabVerdict* judged_in(const Verdict& verdict, const Lab& lab) {
  for (const LabVerdict& one : verdict.labs) {
    if (one.lab.name == lab.name) return &one;
  }
  return nullptr;
}

std::string status_of(const Verdict& verdict, const Lab& lab, const LabVerdict* judged) {
  if (!verdict.unreadable.empty()) return "unreadable";
  const auto& absent = verdict.absent;
  if (std::ranges::find(absent, lab.name) != absent.end()) return "no file";
  if (!verdict.not_judged.empty()) return "not judged";
  if (judged == nullptr) return "";
  if (!judged->no_program.empty()) return "no program";
  return judged->on_reference.empty() ? "judged" : "judged on reference";
}

}  // namespace

std::string csv_field(const std::string& text) {
  std::string line = sandbox::printable_line(text);
  if (begins_formula(text)) line.insert(0, "'");
  if (line.find_first_of("\",;' ") == std::string::npos) return line;
  return '"' + with_replacements(line, {{"\"", "\"\""}}) + '"';
}

std::string reason_of(const Verdict& verdict) {
  if (!verdict.unreadable.empty()) return "unreadable: " + verdict.unreadable;
  if (!verdict.not_judged.empty()) return "not judged: " + verdict.not_judged;
  std::vector<std::string> reasons;
  if (!verdict.others.empty()) {
    std::vector<std::string> missing;
    for (const LabVerdict& lab : verdict.labs) {
      const auto& absent = verdict.absent;
      if (std::ranges::find(absent, lab.lab.name) != absent.end())
        missing.push_back(lab.lab.file());
    }
    if (!missing.empty() || verdict.labs.empty()) {
      reasons.push_back(
          fmt::format("no {}; there is: {}",
                      missing.empty() ? "lab's file" : fmt::format("{}", fmt::join(missing, ", ")),
                      fmt::join(verdict.others, ", ")));
    }
  }
  if (!verdict.jail_complete) {
    reasons.emplace_back("judged without the sandbox: no seccomp on this machine");
  } else if (!verdict.reads_confined) {
    reasons.emplace_back("compiled without confinement: no Landlock on this machine");
  }
  return fmt::format("{}", fmt::join(reasons, "; "));
}

std::string grade_table(const std::vector<LabColumns>& labs, const std::vector<Verdict>& verdicts) {
  std::string table = "id,seed,version,seconds,reason";
  for (const LabColumns& one : labs) {
    table += ',' + csv_field(one.lab.name + " status") + ',' + csv_field(one.lab.name + " total");
  }
  for (const LabColumns& one : labs) {
    for (const std::string& check : one.checks) table += ',' + csv_field(check);
  }
  table += '\n';
  for (const Verdict& verdict : verdicts) {
    table +=
        fmt::format("{},{},{},{:.1f},{}", csv_field(verdict.submission), verdict.seed,
                    csv_field(verdict.version), verdict.seconds, csv_field(reason_of(verdict)));
    const bool is_grade = verdict.not_judged.empty() && verdict.unreadable.empty();
    for (const LabColumns& one : labs) {
      const LabVerdict* const judged = judged_in(verdict, one.lab);
      table += ',' + csv_field(status_of(verdict, one.lab, judged)) + ',';
      if (judged != nullptr && is_grade) table += fmt::format("{:g}", judged->earned());
    }
    for (const LabColumns& one : labs) {
      const LabVerdict* const judged = judged_in(verdict, one.lab);
      for (const std::string& check : one.checks) {
        table += ',';
        if (judged == nullptr || !is_grade) continue;
        for (const CheckResult& result : judged->checks) {
          if (result.check.name == check) table += fmt::format("{:g}", result.earned());
        }
      }
    }
    table += '\n';
  }
  return table;
}

std::vector<std::vector<std::string>> csv_rows(std::string_view table) {
  constexpr std::string_view mark = "\xef\xbb\xbf";  // the byte order mark of spreadsheets
  if (table.starts_with(mark)) table.remove_prefix(mark.size());
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> row;
  std::string field;
  bool quoted = false, begun = false;
  const auto end_field = [&] {
    const bool made_harmless =
        field.starts_with('\'') && begins_formula(std::string_view(field).substr(1));
    row.push_back(made_harmless ? field.substr(1) : field);
    field.clear();
  };
  const auto end_row = [&] {
    if (begun || !field.empty()) {
      end_field();
      rows.push_back(std::move(row));
    }
    row.clear();
    begun = false;
  };
  for (std::size_t i = 0; i < table.size(); ++i) {
    const char c = table[i];
    const bool next_is_quote = i + 1 < table.size() && table[i + 1] == '"';
    if (c == '"' && quoted && next_is_quote) {
      field += table[++i];
    } else if (c == '"') {
      quoted = !quoted;
      begun = true;
    } else if (quoted) {
      field += c;
    } else if (c == ',') {
      end_field();
      begun = true;
    } else if (c == '\n') {
      end_row();
    } else if (c != '\r') {
      field += c;
    }
  }
  end_row();
  return rows;
}

}  // namespace mc::grader
