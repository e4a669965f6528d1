#pragma once
// The result of judging. Every report (terminal, JSON, CSV) is generated from it alone.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/checkout/labs.hpp"
#include "judge/submission/submission.hpp"
#include "protocol/records.hpp"

namespace mc::grader {

enum class Status {
  passed,
  failed,
  not_written,     ///< the task throws mc::todo
  withheld,        ///< passed, but its task's main check did not, so it does not count
  waiting,         ///< failed, and so did a task or a lab that it needs: one fault, not two
  not_run,         ///< the task's time was used up, or there is no program
  not_judged,      ///< the machine failed: no verdict, and no zero
  internal_error,  ///< a fault of the autograder: no record of this check
};

/// A check as it is registered, before it runs.
struct Check {
  std::string name;                ///< "1.3 two passes keep their digits under a large mean"
  std::string task;                ///< "1.3"
  std::vector<std::string> needs;  ///< tasks ("1.1") and labs ("3") without which it cannot pass
  double points = 0;
  bool is_main = false;  ///< the main check of its task
  bool is_edge = false;  ///< refusals, edge cases, speed: other tasks do not wait for it
  /// Shown and judged, without points: tagged [stretch] in place of points.
  bool is_stretch() const { return points == 0; }
};

struct CheckResult {
  Check check;
  Status status = Status::internal_error;
  std::string report;   ///< of a failure: measured, expected, because, likely
  std::string printed;  ///< the submission's output during the check
  std::string repeat;   ///< the command that repeats this check, seed included
  /// Of a failure: the last call, as an experiment and its arguments on the command line.
  std::vector<std::string> call;
  std::string by_hand;    ///< the command that repeats this call; empty without a call
  std::string costliest;  ///< its costliest measurement: "0.12 stream", seconds of CPU time
  /// Each cost that was judged by its growth: "1.8 32 a candidate", the growth and its limit.
  std::vector<std::string> growths;
  std::vector<protocol::PValue> p_values;
  double seconds = 0;
  double earned() const { return status == Status::passed ? check.points : 0; }
  /// Is this where a student goes on? Not where another check is the reason.
  bool is_open() const {
    return status != Status::passed && status != Status::waiting && status != Status::withheld &&
           !check.is_stretch();
  }
};

/// The speed of a speed task and the error of its points. Reported, never graded.
struct Speed {
  std::string name;                  ///< "2.8 uniforms"
  double nanoseconds = 0;            ///< per number, value or point
  std::optional<double> plain = {};  ///< of the plain definition or loop, timed in turn
  double noise = 0;                  ///< half the range of the ratios, as a part of the ratio
  std::optional<double> error = {};  ///< RMSE of its points on `integrand`, relative
  std::uint64_t points = 0;
  std::string integrand = {};
};

struct LabVerdict {
  Lab lab;
  std::vector<CheckResult> checks;
  std::string no_program;               ///< why there is no program to judge; empty if there is one
  std::vector<std::string> unfinished;  ///< labs and tasks that checks wait for: "3", "1.4"
  double seconds = 0;
  std::vector<Speed> speed;  ///< of the speed tasks that passed
  /// The labs it depends on, if the reference's files took the place of the submission's.
  std::vector<std::string> on_reference = {};
  double earned() const;
  double points() const;
  /// The speed relative to plain code: the geometric mean over its speed tasks.
  std::optional<double> times_plain() const;
};

struct Verdict {
  std::string submission;
  std::string found_in;  ///< the folder in it that has the files, if not the top
  std::string contents;  ///< a hash of all submitted text: if it changes, it is judged again
  std::uint64_t seed = 0;
  std::string version, flags;
  bool jail_complete = true;
  bool reads_confined = true;  ///< does the kernel keep a compiler from other files (Landlock)?
  /// Why this is not a grade (the machine or the autograder failed); empty if it is one. Partial
  /// results may be shown, but they give neither points nor a zero.
  std::string not_judged;
  /// Why the submission cannot be read; empty if it can. Not a grade either, but not a fault of the
  /// machine.
  std::string unreadable;
  std::vector<LabVerdict> labs;
  std::vector<std::string> absent;  ///< labs without a file
  std::vector<std::string> others;  ///< files that may have been meant: "variance (1).cpp"
  double seconds = 0;
  double earned() const;
  double points() const;
};

/// The number of a task within its lab: 10 for "1.10".
int task_number(const std::string& task);

/// "lab 3", or "task 1.4": what a check needs.
std::string lab_or_task(const std::string& need);

/// "passed", "failed", "not written yet", "waiting for 1.1", "not run", "internal error"
std::string describe(const CheckResult& result, const LabVerdict& verdict);

}  // namespace mc::grader
