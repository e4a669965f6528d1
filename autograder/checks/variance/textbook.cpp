// 1.2: the textbook formula.

#include <cmath>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "list_results.hpp"

namespace mc::checks {
namespace {

/// What the formula keeps: n additions lose n eps, and the difference magnifies it.
double textbook_floor(const ExactMoments& exact) {
  return floor_of(exact.count * eps * condition(exact) * condition(exact));
}
const std::string because_textbook =
    "n additions lose n eps, and the difference magnifies it by E{X^2} / Var{X}";

const auto by_textbook = [](const Values& x) { return MEASURE(variance_textbook, x); };

CHECK_CASE("1.2 the textbook formula gives the variance of tame data", "[1.2][main][points:5]") {
  Rng rng = check_rng();
  const std::vector<List> lists = tame_lists(rng, 2, 0.5, 2.5), others = lists_of_any_scale(rng);
  Results variances = variances_of(lists, by_textbook, textbook_floor);
  variances.is_tame = true;
  variances.expect(because_textbook, "E{X^2} - E{X}^2, times n/(n-1)");
  variances_of(others, by_textbook, textbook_floor)
      .expect(because_textbook, "small is not zero: use no threshold, no float");
}

CHECK_CASE("1.2 the textbook formula is undefined or infinite where the variance is",
           "[1.2][edge][points:1]") {
  Rng rng = check_rng();
  expect_no_variance(rng, by_textbook);
}

CHECK_CASE("1.2 the textbook formula loses two digits for each digit of the mean",
           "[1.2][edge][points:4]") {
  Rng rng = check_rng();
  constexpr std::size_t size = 4, lists = 40;
  for (const double offset : {1e9, 1e11, 1e3, 1e5, 1e7}) {
    Values x(size * lists);
    for (double& value : x) value = offset + uniform(rng, 0, 20);
    const auto got = MEASURE(variances, 2, x, size);
    const auto& variances = got.exactly(lists, any_number);
    Results results;
    double squares = 0;
    const double unit = eps * offset * offset;
    for (std::size_t i = 0; i < lists; ++i) {
      const List list(Values(x.begin() + i * size, x.begin() + (i + 1) * size));
      results.add(fmt::format("{}[{}]", got.call, i), variances[i], list.exact.variance,
                  10 * size * unit, [=] { return variance_suspects(list); });
      squares += std::pow((variances[i] - list.exact.variance) / unit, 2);
    }
    results.expect(because_textbook, "E{X^2} - E{X}^2 in double, times n/(n-1)");
    // E{X^2} alone is rounded to a multiple of eps E{X^2} / 2 at least, so the error has an RMS of
    // 0.14 eps E{X^2} or more. A seventh of it, forty times: less than one in 1e30.
    const double rms = std::sqrt(squares / lists);
    expect_that(
        rms > 0.02, fmt::format("{} has errors of {:.2g}, RMS", got.call, rms * unit),
        fmt::format("errors of about eps E{{X^2}} = {:.2g}, as E{{X^2}} - E{{X}}^2 has here "
                    "in double",
                    unit),
        "this task shows how the formula fails: it subtracts two numbers that are rounded "
        "to 16 digits, and nearly equal",
        "this is a better algorithm under the textbook's name, or a wider type; keep it "
        "for 1.3");
  }
}

}  // namespace
}  // namespace mc::checks
