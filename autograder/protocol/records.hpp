#pragma once
// What a process of checks sends to the grader, over one pipe: one line per record, "kind text",
// line ends in the text escaped.

#include <string>
#include <string_view>
#include <vector>

namespace mc::protocol {

enum class RecordKind {
  printed,  ///< what the submission wrote to standard output
  todo,     ///< a task that is not written yet
  p_value,  ///< of a random test (PValue)
  call,     ///< what was asked last before a check failed: an experiment, its arguments as typed
  cost,     ///< of the costliest measurement so far: seconds of CPU time, the experiment
  machine,  ///< the machine failed, and how: what the check says is no verdict
  ended,    ///< a test case has ended (CheckEnd)
};

struct Record {
  RecordKind kind;
  std::string text;
};

/// One line, without its end.
std::string line_of(const Record& record);

/// The records in what a check wrote. Lines that are none are passed over.
std::vector<Record> records_in(std::string_view lines);

/// How a test case ended, as Catch2 saw it. Its status comes from this and from nothing else: an
/// exit status says nothing of one case, and a record that is missing is no success.
struct CheckEnd {
  std::string name, tags;
  bool passed = false;   ///< at least one assertion, and none failed
  bool crashed = false;  ///< an exception or a signal ended it: the check itself is at fault
  std::string message;   ///< of the first failure
};
std::string text_of(const CheckEnd& end);
/// The cases that ended, in order. What is not the text of one is passed over.
std::vector<CheckEnd> check_ends_in(const std::vector<Record>& records);

/// A random check's word on itself: under the null hypothesis p is uniform, and it fails below
/// alpha.
struct PValue {
  std::string null;
  double p = 0, alpha = 0;
};
std::string text_of(const PValue& value);
PValue p_value_in(const std::string& text);

}  // namespace mc::protocol
