// 5.7: random shifts (Cranley and Patterson's rotations).

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_inverses.hpp"
#include "checks/halton/randomness.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

/// The distance of two numbers on the circle of length 1.
double around(double a, double b) {
  const double apart = wrapped(a - b);
  return std::min(apart, 1 - apart);
}

/// Whether they left the unit cube is asked only if `inside_too`.
/// Sums and differences below 2 are rounded by 2^-53 at most: two of them for each of two points,
/// and five more when they are compared. Twice that.
constexpr double shift_tolerance = 18 * half_ulp;

void expect_one_shift(const std::string& call, std::span<const double> from,
                      std::span<const double> to, std::size_t d, bool inside_too) {
  const double shift = wrapped(to[0] - from[0]);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const bool inside = (to[i] >= 0 && to[i] < 1) || !inside_too;
    if (inside && around(to[i] - from[i], shift) <= shift_tolerance) continue;
    expect_that(false,
                fmt::format("{}: coordinate {} of point {} went from {:.6g} to {}, that of point 0 "
                            "from {:.6g} to {}",
                            call, d, i, from[i], shown_number(to[i]), from[0], shown_number(to[0])),
                "all points moved by the same vector, around the unit cube",
                "shifted points have the differences that they had before, on the circle",
                inside ? "one random number for an axis, not one for a point"
                       : "it left the unit interval: take 1 off where the sum reaches it");
  }
  pass();
}

CHECK_CASE("5.7 one shift moves all points and wraps around", "[5.7][points:3][main]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 50, dims = 3;
  const auto points = uniform_values(rng, n * dims, 0, 1);
  const auto measured = MEASURE(random_shift, points, dims, 4, rng());
  const SetsOfPoints got(measured.exactly(4 * n * dims, any_number), n, dims);
  for (std::size_t set = 0; set < 4; ++set) {
    for (std::size_t d = 0; d < dims; ++d) {
      expect_one_shift(measured.call, std::span(points).subspan(d * n, n), got.column(set, d), d,
                       true);
    }
  }
}

CHECK_CASE("5.7 the shift is uniform and of its own for each axis", "[5.7][points:3]") {
  Rng rng = check_rng();
  constexpr std::size_t times = 2000, dims = 2, n = 3;
  const std::vector<double> points{0, 0.5, 0.75, 0, 0.25, 0.5};
  const auto measured = MEASURE(random_shift, points, dims, times, rng());
  const SetsOfPoints got(measured.exactly(times * dims * n, any_number), n, dims);
  std::vector<double> x, y, apart, turns;
  std::size_t equal = 0, still = 0;
  for (std::size_t i = 0; i < times; ++i) {
    for (std::size_t d = 0; d < dims; ++d) {
      expect_one_shift(measured.call, std::span(points).subspan(d * n, n), got.column(i, d), d,
                       false);
    }
    x.push_back(wrapped(got.column(i, 0)[0]));
    y.push_back(wrapped(got.column(i, 1)[0]));
    apart.push_back(wrapped(x[i] - y[i]));
    equal += x[i] == y[i] ? 1u : 0u;
    if (i == 0) continue;
    turns.push_back(wrapped(x[i] - x[i - 1]));
    still += x[i] == x[i - 1] ? 1u : 0u;
  }
  const Hints hints{{},
                    still == times - 1 ? "the shift is the same each time: draw it from the "
                                         "generator that is passed in"
                    : equal == times   ? "one shift for every axis: points only move along the "
                                         "diagonal"
                                       : "a uniform number in [0, 1) for each axis"};
  const std::string& call = measured.call;
  expect_distribution(call + ", x", x, uniform_cdf, {"the shift along x is uniform", one_alpha},
                      hints);
  expect_distribution(call + ", y", y, uniform_cdf, {"the shift along y is uniform", one_alpha},
                      hints);
  expect_distribution(call + ", x - y", apart, uniform_cdf,
                      {"the shifts along x and y are independent", one_alpha}, hints);
  expect_distribution(call + ", x now against x before", turns, uniform_cdf,
                      {"each shift is independent of the one before", one_alpha}, hints);
}

CHECK_CASE("5.7 shifted points stay in the unit cube", "[5.7][points:2][edge]") {
  Rng rng = check_rng();
  const std::vector<double> points{0, 0.5, 1 - half_ulp, 1 - 2 * half_ulp, 1 - 3 * half_ulp};
  const auto measured = MEASURE(random_shift, points, 1, 1000, rng());
  const SetsOfPoints got(measured.exactly(5000, unit), 5, 1);
  // For every shift the point just below 1 goes to just below the shift.
  for (std::size_t set = 0; set < got.size(); ++set) {
    expect_one_shift(measured.call, points, got.column(set, 0), 0, true);
  }
}

}  // namespace
}  // namespace mc::checks
