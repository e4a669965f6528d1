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
  call,     ///< the last call before a check failed: an experiment and its typed arguments
  cost,     ///< of the costliest measurement so far: seconds of CPU time, the experiment
  growth,   ///< of a cost, and its limit: "1.8 32 a candidate"
  machine,  ///< the machine failed, and how: the check's result is not a verdict
  ended,    ///< a test case ended (CheckEnd)
};

struct Record {
  RecordKind kind;
  std::string text;
};

/// One line, without its line end.
std::string line_of(const Record& record);

/// The records in a check's output. Skips lines that are not records.
std::vector<Record> records_in(std::string_view lines);

/// How a test case ended, according to Catch2. Its status comes only from this: an exit status does
/// not identify the case, and a missing record is not a success.
struct CheckEnd {
  std::string name, tags;
  bool passed = false;   ///< at least one assertion, and none failed
  bool crashed = false;  ///< an exception or a signal ended it: the check itself is at fault
  std::string message;   ///< of the first failure
};
std::string text_of(const CheckEnd& end);
/// The cases that ended, in order. Skips records with malformed text.
std::vector<CheckEnd> check_ends_in(const std::vector<Record>& records);

/// The p-value of a random check: uniform under the null hypothesis; the check fails if it is below
/// alpha.
struct PValue {
  std::string null;
  double p = 0, alpha = 0;
};
std::string text_of(const PValue& value);
PValue p_value_in(const std::string& text);

}  // namespace mc::protocol
