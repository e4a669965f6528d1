#pragma once
// What a judgment comes to. Every report (terminal, JSON, CSV) is drawn from this and nothing
// else.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grader/checkout/labs.hpp"
#include "protocol/records.hpp"

namespace mc::grader {

enum class Status {
  passed,
  failed,
  not_written,     ///< the task throws mc::todo
  withheld,        ///< passed, but it counts only with its task's main check, which did not
  waiting,         ///< failed, and so did a task or a lab that it needs: one fault, not two
  not_run,         ///< the task's time was used up, or there is no program
  not_judged,      ///< the machine failed: no verdict, and no zero
  internal_error,  ///< the autograder's own fault: no record of this check
};

/// A check as it is registered, before it runs.
struct Check {
  std::string name;                ///< "1.3 two passes keep their digits under a large mean"
  std::string task;                ///< "1.3"
  std::vector<std::string> needs;  ///< tasks ("1.1") and labs ("3") without which it cannot pass
  double points = 0;
  bool is_main = false;  ///< of its task: what the task is about
  bool is_edge = false;  ///< refusals, edge cases, speed: other tasks do not wait for it
  bool is_slow = false;  ///< takes much of the lab's time: started first, alongside the others
};

struct CheckResult {
  Check check;
  Status status = Status::internal_error;
  std::string report;   ///< of a failure: measured, expected, because, likely
  std::string printed;  ///< what the submission printed meanwhile
  std::string repeat;   ///< the command that repeats this check, seed included
  /// Of a failure: what was asked last, an experiment and its arguments as one types them.
  std::vector<std::string> call;
  std::string by_hand;    ///< the command that asks this again; empty where nothing was asked
  std::string costliest;  ///< its costliest measurement: "0.12 stream", seconds of CPU time
  std::vector<protocol::PValue> p_values;
  double seconds = 0;
  double earned() const { return status == Status::passed ? check.points : 0; }
};

/// How fast a speed task is, and how good its points. Reported, never graded.
struct Speed {
  std::string name;                       ///< "2.8 uniforms"
  double nanoseconds = 0;                 ///< a number, a value, a point
  std::optional<double> reference;        ///< of the solution
  bool is_estimate = false;               ///< by the ratio that is kept with the lab, without it
  std::optional<double> error;            ///< RMSE of its points on `integrand`
  std::optional<double> reference_error;  ///< of the solution's, as many points
  std::uint64_t points = 0;
  std::string integrand;
  double addition = 0;  ///< nanoseconds per addition of a running sum, measured in the same run
};

struct LabVerdict {
  Lab lab;
  std::vector<CheckResult> checks;
  std::string no_program;               ///< why there is none to judge; empty where there is
  std::vector<std::string> unfinished;  ///< what of other labs some checks wait for: "3", "1.4"
  double seconds = 0;
  std::vector<Speed> speed;  ///< of the speed tasks that passed
  double earned() const;
  double points() const;
  /// How many times as fast as the solutions: the geometric mean of its speed tasks.
  std::optional<double> times_the_reference() const;
};

struct Verdict {
  std::string submission;
  std::string found_in;  ///< where in it the files are, if not at its top
  std::string contents;  ///< all that was handed in: other contents are judged again
  std::uint64_t seed = 0;
  std::string version, flags;
  bool jail_complete = true;
  /// Why this is no grade: the machine or the autograder failed; empty where it is one. What was
  /// judged by then can be shown, but no points may be drawn from it, and no zero.
  std::string not_judged;
  /// Why nothing could be read of what was handed in; empty where it could. No grade either, but no
  /// fault of the machine's.
  std::string unreadable;
  std::vector<LabVerdict> labs;
  std::vector<std::string> absent;  ///< labs of which there is no file
  double seconds = 0;
  double earned() const;
  double points() const;
};

/// The number of a task within its lab: 10 for "1.10".
int task_number(const std::string& task);

/// "passed", "failed", "not written yet", "waiting for 1.1", "not run", "internal error"
std::string describe(const CheckResult& result, const LabVerdict& verdict);

}  // namespace mc::grader
