#pragma once
// Functions of a submission are functions of their arguments: a call gives the same bytes alone, in
// a process of its own, as after other calls, and twice. Every check is followed by a replay of
// what it measured, in one process and in reverse order; no check of a lab does this by hand.

#include <string>

#include "sandbox/jail.hpp"

namespace mc::checks {

/// Keeps a measurement for the replay, if it was cheap enough.
void keep_for_replay(const std::string& call, const std::string& request,
                     const sandbox::Outcome& outcome);

/// Ends the check where a measurement of it gives another result after others. Forgets them all.
void replay();

/// The body of a check and its replay.
void run_check(void (*body)());

}  // namespace mc::checks

/// A check: CHECK_CASE("1.6 the covariance of pairs", "[1.6][points:6][main]") { … }
#define CHECK_CASE(...) MC_CHECK_CASE_NAMED(__COUNTER__, __VA_ARGS__)
#define MC_CHECK_CASE_NAMED(number, ...) MC_CHECK_CASE_OF(number, __VA_ARGS__)
#define MC_CHECK_CASE_OF(number, ...)             \
  static void check_body_##number();              \
  TEST_CASE(__VA_ARGS__) {                        \
    ::mc::checks::run_check(check_body_##number); \
  }                                               \
  static void check_body_##number()
