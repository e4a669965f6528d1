#pragma once
// From a program to a verdict: runs a lab's checks, one process each, and reads their records.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "grader/build.hpp"
#include "grader/process.hpp"
#include "grader/verdict.hpp"

namespace mc::grader {

struct JudgeOptions {
  std::uint64_t seed = 0;
  bool skip_slow = false;   ///< leave out checks tagged [slow]
  std::string only;         ///< a task ("1.3"): judge its checks alone; empty: all
  unsigned workers = 2;     ///< checks at the same time
  double lab_seconds = 60;  ///< what is not started by then is not run
  std::string submission;   ///< the directory, for the command that repeats a check
};

/// The checks of a lab, from a run of them without a program. Throws MachineError where the lab's
/// checks are not built.
std::vector<Check> expected_checks(const Layout& layout, const Lab& lab);

LabVerdict judge_lab(const Layout& layout, const Lab& lab, const Built& built,
                     const JudgeOptions& options);

/// A failed check that needs another lab is waiting while that lab, "3", is short of full marks, as
/// `is_finished` says; it is asked only where it matters.
void wait_for_labs(LabVerdict& verdict,
                   const std::function<bool(const std::string& lab)>& is_finished);

/// Runs the hidden cases with this tag of a lab's checks on a program. `options` brings what they are
/// told and how long they may take; they say what happened in Catch2's XML.
ProcessResult run_hidden_cases(const Layout& layout, const Lab& lab, const Program& program,
                               const std::string& tag, ProcessOptions options);

/// One check's part of Catch2's XML report, version 2 or 3 (they differ in the root only).
struct XmlRecord {
  std::string name, tags;
  bool success = false;
  std::string message;  ///< of the first failure
};
std::vector<XmlRecord> read_catch_xml(std::string_view xml);

}  // namespace mc::grader
