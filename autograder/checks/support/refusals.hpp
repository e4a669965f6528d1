#pragma once
// Calls with arguments that a header forbids: each throws std::invalid_argument, and its text names
// the argument that is wrong.

#include <string>
#include <vector>

#include "checks/support/measure.hpp"

namespace mc::checks {

/// A call with one argument that is wrong.
struct InvalidCall {
  Call call;             ///< of MEASURE_OUTCOME(...)
  std::string argument;  ///< its name, or several of which one will do: "x|y|size"
  std::string because;   ///< "six points do not fill nine cells"
  /// Said where the call returns a value: what a wrong answer forgets here.
  std::string hint = "check the arguments first, and throw std::invalid_argument";
};

/// Each call throws std::invalid_argument, whatever its text says.
void expect_refused(const std::vector<InvalidCall>& calls);

/// Of the calls that throw std::invalid_argument (one at least), each says in its text which
/// argument is wrong.
void expect_argument_named(const std::vector<InvalidCall>& calls);

/// Both.
inline void expect_refused_by_name(const std::vector<InvalidCall>& calls) {
  expect_refused(calls);
  expect_argument_named(calls);
}

}  // namespace mc::checks

/// Both as checks of a task, with their points: REFUSAL_CASES("4.5", "misuse of radial_power is
/// refused", "2", "a refusal names the argument", "1", wrong_rings())
#define REFUSAL_CASES(task, refused, points_refused, named, points_named, ...)  \
  CHECK_CASE(task " " refused, "[" task "][edge][points:" points_refused "]") { \
    ::mc::checks::expect_refused(__VA_ARGS__);                                  \
  }                                                                             \
  CHECK_CASE(task " " named, "[" task "][edge][points:" points_named "]") {     \
    ::mc::checks::expect_argument_named(__VA_ARGS__);                           \
  }
