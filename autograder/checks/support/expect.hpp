#pragma once
// What a check may expect of a number, each telling its story when it fails: measured, expected,
// because, likely. Where the check is read about and how it is repeated is added by the grader.

#include <cmath>
#include <concepts>
#include <string>
#include <vector>

#include "checks/support/measure.hpp"

namespace mc::checks {

/// A value that a well-known mistake would give, and what to say if that is what was measured.
struct Suspect {
  double value;
  std::string hint;
};

/// Hints for a failure: that of the first suspect that the measured value equals, else `otherwise`.
struct Hints {
  std::vector<Suspect> suspects;
  std::string otherwise;
};

/// The digits of `exact` that `got` has: -log10 of the relative error (of the error, where `exact`
/// is 0). 17 where they are equal, else -99 where one of them is not finite.
double digits(double got, double exact);

/// |got - exact| <= tolerance.
void expect_within(const std::string& what, double got, double exact, double tolerance,
                   const std::string& because, const Hints& hints);

/// The same with hints that take long to find: computed only if the check fails.
template <std::invocable Find>
void expect_within(const std::string& what, double got, double exact, double tolerance,
                   const std::string& because, const Find& find) {
  const bool holds = std::abs(got - exact) <= tolerance;
  expect_within(what, got, exact, tolerance, because, holds ? Hints{} : Hints(find()));
}

/// `holds` is true; `expected` says in words what that is.
void expect_that(bool holds, const std::string& measured, const std::string& expected,
                 const std::string& because, const std::string& hint);

/// `got` is NaN, as in numpy and R for what is undefined.
void expect_nan(const std::string& what, double got, const std::string& because);

}  // namespace mc::checks
