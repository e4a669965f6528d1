#pragma once
// Catch2 2.13 (Debian 12, Ubuntu 22.04) or 3.x, and checks, whose calls are replayed.

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/interfaces/catch_interfaces_capture.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#include "common/rng.hpp"

namespace mc::checks {

/// Runs the body of a check with the check's generator, then replays its calls, in one process, in
/// reverse order, and after calls that share all arguments but one: the results must be the same as
/// before, when each call had its own process.
void run_check(void (*body)(Rng&));

}  // namespace mc::checks

/// A check: CHECK_CASE("1.6 the covariance of pairs", "[1.6][points:6][main]") { … }
/// Its body uses `rng`, the check's generator: fresh in every run, repeatable by --seed.
/// A check of time or memory is a TEST_CASE: its calls are not replayed.
#define CHECK_CASE(...) MC_CHECK_CASE_NAMED(__COUNTER__, __VA_ARGS__)
#define MC_CHECK_CASE_NAMED(number, ...) MC_CHECK_CASE_OF(number, __VA_ARGS__)
#define MC_CHECK_CASE_OF(number, ...)             \
  static void check_body_##number(::mc::Rng&);    \
  TEST_CASE(__VA_ARGS__) {                        \
    ::mc::checks::run_check(check_body_##number); \
  }                                               \
  static void check_body_##number([[maybe_unused]] ::mc::Rng& rng)
