#pragma once
// Calls with invalid arguments throw std::invalid_argument, with a message that names the argument.

#include <string>
#include <vector>

#include "checks/support/measure.hpp"

namespace mc::checks {

struct InvalidCall {
  Call call;             ///< of MEASURE_OUTCOME(...)
  std::string argument;  ///< its name, or alternatives: "x|y|size"
  std::string because;   ///< "six points do not fill nine cells"
  /// The rule if the call returns a value.
  std::string rule = "refuse this argument by std::invalid_argument, before computing anything";
};

/// Each call throws std::invalid_argument, with any message.
void expect_refused(const std::vector<InvalidCall>& calls);

/// At least one call throws std::invalid_argument, and every message names the wrong argument.
void expect_argument_named(const std::vector<InvalidCall>& calls);

inline void expect_refused_by_name(const std::vector<InvalidCall>& calls) {
  expect_refused(calls);
  expect_argument_named(calls);
}

}  // namespace mc::checks

/// Both as checks of a task, with points: REFUSAL_CASES("4.5", "misuse of radial_power is refused",
/// "2", "a refusal names the argument", "1", wrong_rings())
#define REFUSAL_CASES(task, refused, points_refused, named, points_named, ...)  \
  CHECK_CASE(task " " refused, "[" task "][edge][points:" points_refused "]") { \
    ::mc::checks::expect_refused(__VA_ARGS__);                                  \
  }                                                                             \
  CHECK_CASE(task " " named, "[" task "][edge][points:" points_named "]") {     \
    ::mc::checks::expect_argument_named(__VA_ARGS__);                           \
  }
