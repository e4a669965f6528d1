#pragma once
// Reports of a verdict: for a student at a terminal, for Gradescope, for a spreadsheet.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "judge/judging/verdict.hpp"
#include "runner/text.hpp"

namespace mc::grader {

struct Terminal {
  bool color = false;
  std::size_t width = 100;
  bool interactive = false;  ///< can a line be rewritten?
};

/// The terminal on standard output; color only there, and not with NO_COLOR; at most 100 columns.
Terminal this_terminal();

/// Is this descriptor a terminal where a line can be rewritten?
bool is_interactive(int descriptor);

/// The columns of the terminal on this descriptor; 0 if it is not one.
std::size_t window_columns(int descriptor);

/// One lab, check by check, with the report of each failure.
std::string report_lab(const LabVerdict& lab, const Verdict& verdict, const Terminal& terminal);

/// The report of a failed check with the section to read and the commands that repeat it: `repeat`
/// judges the check again.
std::string failure_report(const LabVerdict& lab, const CheckResult& result,
                           const std::string& repeat);

/// The lines of a lab's speed tasks: "2.8 uniforms  0.6 ns, 1.1 times as fast as the reference".
std::string report_speed(const LabVerdict& lab);

/// A line for each submission and lab; names take at least `columns`.
std::string report_summary(const std::vector<Verdict>& verdicts, std::size_t columns = 10);

using text::columns_of;

/// Text wrapped at blanks to `width` columns; lines after the first are indented by `indent`
/// blanks.
std::string wrapped(std::string_view text, std::size_t width, std::size_t indent);

/// "judged with the reference's variance"; empty if only the submission's files were judged.
std::string reference_line(const LabVerdict& lab);

/// Why there is no grade; empty if there is one.
std::string not_judged_line(const Verdict& verdict);

/// The warning for every grade given without the complete jail; empty with it.
std::string jail_warning(const Verdict& verdict);

/// Gradescope's results.json: every check, its points, its report; complete in every case. Students
/// read it outside of their checkout, so commands name no directory.
std::string results_json(const Verdict& verdict);

}  // namespace mc::grader
