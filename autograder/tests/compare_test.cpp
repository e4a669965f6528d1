// What a comparison says of wrong values when no suspect of the check explains them.
#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "tests/text.hpp"

namespace mc::tests::compare {

using checks::Failure;
using Values = std::vector<double>;

/// Of values that became `got`.
Failure failure_of(const Values& exact, const Values& got) {
  const auto failure = checks::difference(
      {"f()", got}, {.exact = exact, .tolerance = {1e-9}, .otherwise = "no idea"});
  REQUIRE(failure);
  return *failure;
}

TEST_CASE("a comparison says what is true of the wrong values") {
  Values exact(50);
  std::iota(exact.begin(), exact.end(), 0.5);
  const auto changed = [&](auto change) {
    Values got = exact;
    for (std::size_t i = 0; i < got.size(); ++i) change(got[i], i);
    return got;
  };
  const auto capped = failure_of(exact, changed([](double& x, auto) { x = std::min(x, 40.25); }));
  CHECK(capped.likely == "no value is above 40.25: something limits the values");
  CHECK(contains(capped.measured, "the last 10 of 50 values are wrong, from value 40 on"));
  const auto raised = failure_of(exact, changed([](double& x, auto) { x = std::max(x, 9.75); }));
  CHECK(raised.likely == "no value is below 9.75: something limits the values");

  // One wrong value is not a limit, and neither are values that jump over it.
  CHECK(failure_of(exact, changed([](double& x, auto i) { x = i == 7 ? 3 : x; })).likely ==
        "no idea");
  const auto third = failure_of(exact, changed([](double& x, auto i) { x = i % 3 == 1 ? 5 : x; }));
  CHECK(third.likely == "no idea");
  CHECK(contains(third.measured, "17 of 50 values are wrong: every 3rd, from value 1 on"));
}

}  // namespace mc::tests::compare
