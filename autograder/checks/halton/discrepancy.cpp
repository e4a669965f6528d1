// 5.6: star discrepancies, against exact fractions and against the definition, box by box.

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_discrepancy.hpp"
#include "checks/halton/sobol_points.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

using Values = std::vector<double>;

constexpr double discrepancy_tolerance = 1e-14;
const std::string because_discrepancy =
    "the largest of |volume - fraction of the points inside| over all boxes; rounding costs a few "
    "eps";

/// `of(boxes)` is what one finds who looks at these boxes only.
template <class Of>
Hints discrepancy_hints(Of of) {
  return {{{of(Boxes{true, false, true}),
            "only open boxes were looked at: those that end just behind a point count too"},
           {of(Boxes{false, true, true}),
            "only closed boxes were looked at: those that end just before a point count too"},
           {of(Boxes{true, true, false}),
            "only boxes that end at points were looked at: those that end at 1 count too"}},
          "the box may end at a point or at 1, just before it or just behind it"};
}
Hints hints_for(const Values& x) {
  return discrepancy_hints([&](Boxes boxes) { return exact_discrepancy(x, boxes); });
}
Hints hints_for(const Values& x, const Values& y) {
  return discrepancy_hints([&](Boxes boxes) { return exact_discrepancy(x, y, boxes); });
}

void expect_discrepancy(const Values& x) {
  const auto got = MEASURE(star_discrepancy_1d, x);
  expect_within(got.call, got.value, exact_discrepancy(x), discrepancy_tolerance,
                because_discrepancy, [&] { return hints_for(x); });
}

void expect_discrepancy(const Values& x, const Values& y) {
  const auto got = MEASURE(star_discrepancy_2d, x, y);
  expect_within(got.call, got.value, exact_discrepancy(x, y), discrepancy_tolerance,
                because_discrepancy, [&] { return hints_for(x, y); });
}

CHECK_CASE("5.6 the star discrepancy of points of the line", "[5.6][points:4][main]") {
  Rng rng = check_rng();
  struct Known {
    std::size_t n;
    double base_2, base_3;
  };
  // Exact fractions of van der Corput's sequence.
  const Known known[] = {{10, 7. / 40, 17. / 90},
                         {64, 1. / 64, 221. / 5184},
                         {100, 37. / 1600, 239. / 8100},
                         {1000, 157. / 64000, 1267. / 364500},
                         {3, 1. / 2, 1. / 3},
                         {1, 1, 1}};
  for (const std::size_t n : {60u, 7u}) expect_discrepancy(uniform_values(rng, n, 0, 1));
  for (const auto& [n, base_2, base_3] : known) {
    for (const unsigned base : {2u, 3u}) {
      Values x = inverses(base, 0, n);
      std::shuffle(x.begin(), x.end(), rng);
      const auto got = MEASURE(star_discrepancy_1d, x);
      expect_within(got.call, got.value, base == 2 ? base_2 : base_3, discrepancy_tolerance,
                    fmt::format("the first {} of van der Corput's points in base {}", n, base),
                    [&] { return hints_for(x); });
    }
    // Late in the strata the worst interval ends just before a point, early just behind it.
    for (const double place : {0.875, 0.125, 0.5}) {
      Values x(n);
      for (std::size_t i = 0; i < n; ++i) {
        x[i] = (static_cast<double>(i) + place) / static_cast<double>(n);
      }
      const auto got = MEASURE(star_discrepancy_1d, x);
      expect_within(got.call, got.value, std::max(place, 1 - place) / static_cast<double>(n),
                    discrepancy_tolerance,
                    fmt::format("each of the {} strata has a point {} of the way in", n, place),
                    [&] { return hints_for(x); });
    }
  }
  for (const std::size_t n : {2u, 1u}) expect_discrepancy(uniform_values(rng, n, 0, 1));
}

CHECK_CASE("5.6 the star discrepancy of points of the plane", "[5.6][points:4]") {
  Rng rng = check_rng();
  struct Known {
    const char* name;
    Values x, y;
    double exact;
  };
  const Known known[] = {
      {"Halton from 0", inverses(2, 0, 16), inverses(3, 0, 16), 29. / 144},
      {"Halton from 1", inverses(2, 1, 16), inverses(3, 1, 16), 25. / 144},
      {"Halton from 0", inverses(2, 0, 64), inverses(3, 0, 64), 5. / 96},
      {"Halton from 0", inverses(2, 0, 216), inverses(3, 0, 216), 3. / 128},
      {"Hammersley", steps(4), inverses(2, 0, 4), 1. / 2},
      {"Hammersley", steps(16), inverses(2, 0, 16), 11. / 64},
      {"Hammersley", steps(64), inverses(2, 0, 64), 55. / 1024},
      {"Hammersley", steps(256), inverses(2, 0, 256), 263. / 16384},
      {"Sobol'", sobol_points(0, 0, 256), sobol_points(1, 0, 256), 239. / 16384}};
  for (const std::size_t n : {30u, 100u, 5u}) {
    // Nothing on the left and at the top: the worst box is empty and ends at y = 1, and what ends
    // at a point is better by a fifth. Wrong sets of boxes give different numbers here, which they
    // need not elsewhere.
    expect_discrepancy(uniform_values(rng, n, 0.6, 1), uniform_values(rng, n, 0, 0.8));
    expect_discrepancy(uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1));
  }
  for (const auto& [name, x, y, exact] : known) {
    const auto got = MEASURE(star_discrepancy_2d, x, y);
    expect_within(fmt::format("{}, {} points", got.call, x.size()), got.value, exact,
                  discrepancy_tolerance,
                  fmt::format("{}, {} points: {} as an exact fraction", name, x.size(), exact),
                  [&x = x, &y = y] { return hints_for(x, y); });
  }
  // Binary digits 10101…: there a sequence in base 2 is at its worst, far from the nets at 2^k.
  for (const std::size_t n : {171u, 85u}) {
    expect_discrepancy(sobol_points(0, 0, n), sobol_points(1, 0, n));
  }
  for (const std::size_t n : {2u, 1u}) {
    expect_discrepancy(uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1));
  }
}

CHECK_CASE("5.6 points that share coordinates or lie on the border", "[5.6][points:2][edge]") {
  Rng rng = check_rng();
  for (const int side : {4, 8}) {  // corners of a grid: 7/16 and 15/64
    Values x, y;
    for (int i = 0; i < side * side; ++i) {
      x.push_back(static_cast<double>(i % side) / side);
      y.push_back(static_cast<double>(i / side) / side);
    }
    expect_discrepancy(x, y);
  }
  expect_discrepancy({0.875, 0.875, 0.875}, {0.125, 0.25, 0.5});  // the worst box ends at y = 1
  for (int set = 0; set < 10; ++set) {
    Values x, y;
    const std::size_t n = 3 + rng() % 30;
    for (std::size_t i = 0; i < n; ++i) {
      x.push_back(static_cast<double>(rng() % 6) / 5);
      y.push_back(static_cast<double>(rng() % 6) / 5);
    }
    expect_discrepancy(x, y);
    expect_discrepancy(x);
  }
  expect_discrepancy({0, 1, 1, 0.5, 0.5, 0.5});
  expect_discrepancy({0});
  expect_discrepancy({1});
  expect_discrepancy({1, 1, 0}, {0, 1, 1});
  expect_discrepancy({0}, {0});
  expect_discrepancy({1}, {1});
}

/// Products g(x) g(y). Hardy and Krause add the variation over the square and that along its two
/// upper edges: T^2 + 2 T |g(1)|, T being the variation of g.
struct Factor {
  const char* name;
  double (*g)(double);
  double integral, variation;
};

CHECK_CASE("5.6 no error exceeds variation times discrepancy", "[5.6][points:2]") {
  Rng rng = check_rng();
  struct Set {
    const char* name;
    Values x, y;
  };
  // Sizes that are no powers of two, where nothing is as even as it can be: N D* / ln N of Sobol'
  // points is 0.65 at 4,096 and 1.19 at 2,731.
  const std::size_t n = 300 + rng() % 40, m = 341;  // 101010101 in base 2
  const std::uint64_t first = rng() % 1000;
  const Set sets[] = {
      {"Halton", inverses(2, first, n), inverses(3, first, n)},
      {"Hammersley", steps(n), inverses(2, 0, n)},
      {"Sobol'", sobol_points(0, 0, m), sobol_points(1, 0, m)},
      {"random", uniform_values(rng, n, 0, 1), uniform_values(rng, n, 0, 1)},
      // The worst box is empty and ends at y = 1, far above the points.
      {"random right-hand", uniform_values(rng, n, 0.6, 1), uniform_values(rng, n, 0, 0.8)}};
  const Factor factors[] = {
      {"x y", [](double x) { return x; }, 0.5, 1},
      {"(1 - x)(1 - y)", [](double x) { return 1 - x; }, 0.5, 1},
      {"exp(x + y)", [](double x) { return std::exp(x); }, std::exp(1.) - 1, std::exp(1.) - 1},
      {"|x - 1/2| |y - 1/2|", [](double x) { return std::abs(x - 0.5); }, 0.25, 1}};
  constexpr double rounding = 1e-12;  // of sums of 600 numbers below e^2, and more
  for (const auto& [name, x, y] : sets) {
    const auto got = MEASURE(star_discrepancy_2d, x, y);
    const auto size = static_cast<double>(x.size());
    const std::string what =
        fmt::format("{} of {} {} points = {:.17g}", got.call, x.size(), name, got.value);
    for (const auto& [integrand, g, integral, of_g] : factors) {
      double sum = 0;
      for (std::size_t i = 0; i < x.size(); ++i) sum += g(x[i]) * g(y[i]);
      const double error = std::abs(sum / size - integral * integral);
      const double variation = of_g * of_g + 2 * of_g * std::abs(g(1));
      expect_that(error <= variation * got.value + rounding,
                  fmt::format("{}, but the integral of {} by them is wrong by {:.6g}", what,
                              integrand, error),
                  fmt::format("{:.6g} times D* at most", variation),
                  "|error| <= V D*, for any points (Koksma, Hlawka)",
                  "D* is too small: some box was not looked at");
    }
    // A box has the variation 1, and the worst box an error of just D*.
    const Box box = worst_box(x, y);
    const std::string shape = box.closed ? fmt::format("[0, {:.6g}] x [0, {:.6g}]", box.a, box.b)
                                         : fmt::format("[0, {:.6g}) x [0, {:.6g})", box.a, box.b);
    expect_that(
        std::abs(got.value - box.difference) <= discrepancy_tolerance, what,
        fmt::format("{:.17g}", box.difference),
        fmt::format("the area of the box {} and the fraction of the points inside differ by this, "
                    "and no other box is worse",
                    shape),
        got.value < box.difference ? "D* is too small: some box was not looked at"
                                   : "D* is too large: no box is as bad as that");
  }
}

CHECK_CASE("5.6 what is no point of the unit square is refused", "[5.6][points:2][edge]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string because = "points must lie in the unit square";
  for (const double outside : {-0.1, 1.1, nan}) {
    expect_refused(MEASURE_OUTCOME(star_discrepancy_1d, {0.5, outside}), because);
    expect_refused(MEASURE_OUTCOME(star_discrepancy_2d, {0.5, 0.1}, {0.2, outside}), because);
    expect_refused(MEASURE_OUTCOME(star_discrepancy_2d, {outside, 0.1}, {0.2, 0.3}), because);
  }
  expect_refused(MEASURE_OUTCOME(star_discrepancy_1d, {}),
                 "without points there is no fraction inside a box");
  expect_refused(MEASURE_OUTCOME(star_discrepancy_2d, {}, {}),
                 "without points there is no fraction inside a box");
  expect_refused(MEASURE_OUTCOME(star_discrepancy_2d, {0.1, 0.2}, {0.3}),
                 "each point has two coordinates");
}

}  // namespace
}  // namespace mc::checks
