#pragma once
// The calls that a check makes, with their outcomes: made again after the check, in another order.
//
// Functions of a submission are functions of their arguments: a call gives the same bytes alone, in
// its own process, as after other calls, and twice. Every check is followed by a replay of
// its calls, in one process and in reverse order; no check of a lab does this by hand.

#include <string>

#include "sandbox/jail.hpp"

namespace mc::checks {

/// Keeps a call, if it was cheap enough.
void keep_call(const std::string& call, const std::string& request,
               const sandbox::Outcome& outcome);

/// The body of a check and its replay, which fails where a call gives another result after others.
void run_check(void (*body)());

}  // namespace mc::checks

/// A check: CHECK_CASE("1.6 the covariance of pairs", "[1.6][points:6][main]") { … }
/// A check of time or memory is a TEST_CASE: its calls are not replayed.
#define CHECK_CASE(...) MC_CHECK_CASE_NAMED(__COUNTER__, __VA_ARGS__)
#define MC_CHECK_CASE_NAMED(number, ...) MC_CHECK_CASE_OF(number, __VA_ARGS__)
#define MC_CHECK_CASE_OF(number, ...)             \
  static void check_body_##number();              \
  TEST_CASE(__VA_ARGS__) {                        \
    ::mc::checks::run_check(check_body_##number); \
  }                                               \
  static void check_body_##number()
