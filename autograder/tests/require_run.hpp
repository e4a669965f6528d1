#pragma once

#include "checks/support/catch.hpp"
#include "sandbox/process.hpp"

/// Names the result of a program that must end with status 0. A later failure shows its output.
#define REQUIRE_RUN(run, ...)      \
  auto run = __VA_ARGS__;          \
  CAPTURE(run.output, run.errors); \
  REQUIRE(run.succeeded())
