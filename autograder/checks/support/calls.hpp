#pragma once
// The calls that a check makes, with their outcomes: made again after the check, in another order,
// and kept for the next submission.
//
// Functions of a submission are functions of their arguments: a call gives the same bytes alone, in
// a process of its own, as after other calls, and twice. Every check is followed by a replay of
// its calls, in one process and in reverse order; no check of a lab does this by hand.
//
// To start a program takes longer than most calls. A class is judged with one seed, so a check asks
// all its submissions the same. Where the grader names a file for it, a check that passed keeps its
// calls there, and starts with all of them in one process. If anything fails then, what was sent
// ahead is forgotten and the check runs again, with a process for each call: a check fails only in
// this way, and its report is the same as without the file. The grader names no file for programs
// with static variables, which could give other results in one process.

#include <optional>
#include <string>
#include <string_view>

#include "sandbox/jail.hpp"

namespace mc::checks {

/// Keeps a call, if it was cheap enough.
void keep_call(const std::string& call, const std::string& request,
               const sandbox::Outcome& outcome);

/// The outcome of a call that was sent ahead; nothing if it must be made.
std::optional<sandbox::Outcome> sent_ahead(std::string_view request);

/// Ends a check that has failed after calls were sent ahead, so that it runs again without.
void retry_if_sent_ahead();

/// The body of a check and its replay, which fails where a call gives another result after others.
void run_check(void (*body)());

}  // namespace mc::checks

/// A check: CHECK_CASE("1.6 the covariance of pairs", "[1.6][points:6][main]") { … }
/// A check of time or memory is a TEST_CASE: its calls are neither sent ahead, where their own time
/// is not known, nor replayed.
#define CHECK_CASE(...) MC_CHECK_CASE_NAMED(__COUNTER__, __VA_ARGS__)
#define MC_CHECK_CASE_NAMED(number, ...) MC_CHECK_CASE_OF(number, __VA_ARGS__)
#define MC_CHECK_CASE_OF(number, ...)             \
  static void check_body_##number();              \
  TEST_CASE(__VA_ARGS__) {                        \
    ::mc::checks::run_check(check_body_##number); \
  }                                               \
  static void check_body_##number()
