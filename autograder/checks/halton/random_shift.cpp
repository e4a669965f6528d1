// 5.7: random shifts (Cranley-Patterson rotations).

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"

namespace mc::checks {
namespace {

/// Sums and differences below 2 are rounded by 2^-53 at most: two of them for each of two points,
/// and five more when they are compared. Twice that.
constexpr double shift_tolerance = 18 * half_ulp;

/// The shifts of `times` copies of the points: of all points of an axis one, modulo 1.
Uniforms shifts_of(const Values& points, std::size_t dims, std::size_t times, std::uint64_t seed) {
  const std::size_t n = points.size() / dims;
  const auto measured = MEASURE(random_shift, points, dims, times, seed);
  const View got = measured.exactly(times * points.size(), any_number);
  Uniforms shifts{measured.call, dims};
  shifts.name = [](std::size_t d) { return fmt::format("the shift of axis {}", d); };
  for (std::size_t k = 0; k < times * dims; ++k) {
    const View from = View(points).subspan(k % dims * n, n), to = got.subspan(k * n, n);
    const double shift = wrapped(to[0] - from[0]);
    for (std::size_t i = 0; i < n; ++i) {
      const bool inside = to[i] >= 0 && to[i] < 1;
      const double off = std::abs(std::remainder(to[i] - from[i] - shift, 1.0));
      expect_that(inside && off <= shift_tolerance,
                  fmt::format("{}: coordinate {} of point {} went from {:.6g} to {:.17g}{}",
                              measured.call, k % dims, i, from[i], to[i],
                              i == 0 ? ""
                                     : fmt::format(", that of point 0 from {:.6g} to {:.17g}",
                                                   from[0], to[0])),
                  "all points moved by the same vector, around the unit cube",
                  "shifted points have the same differences as before, modulo 1",
                  inside && to[i] > 1 - 1e-6 ? "wrap around at 1, not before"
                  : inside                   ? "one random number for an axis, not one for a point"
                  : to[i] == 1 ? "it was rounded up to 1: subtract 1 from a sum that is 1"
                  : to[i] > 1  ? "it left the unit interval: subtract 1 where the sum is 1 or more"
                               : "it left the unit interval: add to the coordinate, and subtract 1 "
                                 "where the sum is 1 or more");
    }
    shifts.values.push_back(std::min(shift, 1 - half_ulp));
  }
  return shifts;
}

const Randomness shift_is_random = uniform_shift(
    "each call", "the shift is the same each time: draw it from the generator that is passed in");

CHECK_CASE("5.7 one shift moves all points and wraps around", "[5.7][points:3][main]") {
  Rng rng = check_rng();
  const Values points = uniform_values(rng, 50 * 3, 0, 1);
  // Points that do not move, or always by the same vector, pass for shifted ones otherwise.
  expect_independent_uniforms(shifts_of(points, 3, 100, rng()), shift_is_random, true);
}

CHECK_CASE("5.7 each axis has its own uniform shift", "[5.7][points:3]") {
  Rng rng = check_rng();
  for (const std::size_t dims : {3u, 17u}) {
    const Values origin(2 * dims);  // from there, all bits of the shift are seen
    expect_independent_uniforms(shifts_of(origin, dims, 3000, rng()), shift_is_random);
  }
}

CHECK_CASE("5.7 shifted points stay in the unit cube", "[5.7][points:2][edge]") {
  Rng rng = check_rng();
  // For every shift the point just below 1 goes to just below the shift.
  shifts_of({0, 0.5, 1 - half_ulp, 1 - 2 * half_ulp, 1 - 3 * half_ulp, 0x1p-1074, 0x1p-60}, 1, 1000,
            rng());
  // The same seed is the same shift: points that it takes to just below 1, to 1, and past it.
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t seed = rng();
    const double edge = 1 - shifts_of({0, 0}, 1, 1, seed).values[0];
    Values points{edge};
    for (const double off : {half_ulp, 2 * half_ulp, 4 * half_ulp, 0x1p-45, 0x1p-30}) {
      points.insert(points.end(), {edge - off, edge + off});
    }
    for (double& x : points) x = std::clamp(x, 0.0, 1 - half_ulp);
    shifts_of(points, 1, 1, seed);
  }
  for (const std::size_t n : domain::sizes(5000, rng)) {
    shifts_of(uniform_values(rng, n * 2, 0, 1), 2, 2, rng());
  }
}

}  // namespace
}  // namespace mc::checks
