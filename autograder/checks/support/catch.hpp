#pragma once
// Catch2, 2.13 (Debian 12, Ubuntu 22.04) or 3.x: the one place that knows the difference.

#if __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/interfaces/catch_interfaces_capture.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif

#include "checks/support/calls.hpp"
