#include "checks/support/expect.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mc::checks {
namespace {

/// The measured value counts as a suspect's from nine digits on: few enough for additions in
/// another order, too many for chance. One that would have met the expectation is no suspect; and
/// where two mistakes give this very value, it is unknown which it was.
template <class Meets>
std::string hint_for(double got, const Hints& hints, Meets meets) {
  const Suspect* found = nullptr;
  for (const Suspect& suspect : hints.suspects) {
    const double apart = std::abs(got - suspect.value);
    const bool equal = std::isfinite(suspect.value) ? apart <= 1e-9 * std::abs(suspect.value)
                                                    : got == suspect.value;
    if (!equal || meets(suspect.value)) continue;
    if (found != nullptr && found->hint != suspect.hint) return hints.otherwise;
    found = &suspect;
  }
  return found != nullptr ? found->hint : hints.otherwise;
}

}  // namespace

double digits(double got, double exact) {
  if (got == exact) return 17;
  if (!std::isfinite(got) || !std::isfinite(exact)) return -99;
  const double error = std::abs(got - exact);
  return std::min(17.0, -std::log10(exact == 0 ? error : error / std::abs(exact)));
}

void expect_within(const std::string& what, double got, double exact, double tolerance,
                   const std::string& because, const Hints& hints) {
  const auto meets = [=](double value) { return std::abs(value - exact) <= tolerance; };
  if (meets(got)) return pass();
  fail(Failure{fmt::format("{} = {}", what, got),
               tolerance == 0 ? fmt::format("{}, exactly", exact)
               : exact == 0   ? fmt::format("0, or at most {:.3g} away from it", tolerance)
                              : fmt::format("{}, give or take {:.3g}", exact, tolerance),
               because, hint_for(got, hints, meets)});
}

void expect_that(bool holds, const std::string& measured, const std::string& expected,
                 const std::string& because, const std::string& hint) {
  if (!holds) fail(Failure{measured, expected, because, hint});
  pass();
}

void expect_nan(const std::string& what, double got, const std::string& because) {
  expect_that(std::isnan(got), fmt::format("{} = {}", what, got), "NaN", because,
              "return std::numeric_limits<double>::quiet_NaN() for what is undefined");
}

}  // namespace mc::checks
