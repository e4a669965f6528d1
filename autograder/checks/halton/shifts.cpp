// 5.7, 5.10: random shifts (Cranley-Patterson rotations), rank-1 lattices, and the tent transform.

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"
#include "checks/support/constructions.hpp"

namespace mc::checks {
namespace {

using Count = std::uint64_t;

/// The shifts of `times` copies of the points: one for all points of an axis, modulo 1.
Uniforms shifts_of(const Values& points, std::size_t dims, std::size_t times, std::uint64_t seed);
/// All points differ from point 0 by multiples of z / N, modulo 1. Returns the shifts.
Values check_lattice(Count n, Count dims, const std::vector<Count>& seeds);

CHECK_CASE("5.7 one shift moves all points and wraps around", "[5.7][points:3][main]") {
  const Values points = uniform_values(rng, 50 * 3, 0, 1);
  // Points that do not move, or always by the same vector, must fail.
  expect_independent_uniforms(shifts_of(points, 3, 100, rng()), uniform_shift("each call"), true);
}

CHECK_CASE("5.7 each axis has its own uniform shift", "[5.7][needs:5.7][points:3]") {
  for (const std::size_t dims : {3u, 70u, 1u}) {
    const Values origin(2 * dims);  // shows all bits of the shift
    expect_independent_uniforms(shifts_of(origin, dims, dims < 9 ? 3000 : 700, rng()),
                                uniform_shift("each call"));
  }
}

CHECK_CASE("5.7 shifted points stay in the unit cube", "[5.7][needs:5.7][points:2][edge]") {
  // For every shift, the point just below 1 moves to just below the shift.
  shifts_of({0, 0.5, 1 - half_ulp, 1 - 2 * half_ulp, 1 - 3 * half_ulp, 0x1p-1074, 0x1p-60}, 1, 1000,
            rng());
  // The same seed gives the same shift: points that it moves to just below 1, to 1, and beyond.
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
  shifts_of(uniform_values(rng, 70001, 0, 1), 1, 1, rng());
}

CHECK_CASE("5.10 points of a lattice are multiples of z / N", "[5.10][stretch][needs:5.7][main]") {
  for (const Count n : {Count{64}, 2 + rng() % 1000}) {
    for (const Count dims : {2u, 1u, 16u}) check_lattice(n, dims, domain::seeds(rng, 2));
  }
}

CHECK_CASE("5.10 lattices of any size", "[5.10][stretch][needs:5.7]") {
  for (const Count n : domain::sizes(5000, rng)) check_lattice(n, 3, domain::seeds(rng, 1));
  // From N = 65,537 on i z needs 33 bits.
  for (const Count n : {100'003u, 131'072u}) check_lattice(n, 5, domain::seeds(rng, 1));
}

CHECK_CASE("5.10 each axis has its own uniform shift", "[5.10][stretch][needs:5.7]") {
  const SeededConstruction lattice{
      uniform_shift("a lattice", "the shift does not depend on all 64 bits of the seed"_likely),
      [](const Seeds& seeds) {
        Uniforms shifts{fmt::format("lattice(1, 16, {})", shown(seeds)), 16,
                        check_lattice(1, 16, seeds)};
        shifts.name = [](std::size_t d) { return fmt::format("the shift of axis {}", d); };
        return shifts;
      },
      3000};
  expect_random_seeds(lattice, {domain::seeds(rng, 3000), domain::in_a_row(rng(), 3000),
                                domain::seeds_by_bit(rng)});
}

CHECK_CASE("5.10 the tent transform folds the line", "[5.10][stretch]") {
  Values x = uniform_values(rng, 20, 0, 1);
  x.insert(x.end(), {0.25, 0.75, 0.5 - 0x1p-54, 0.5, 0.5 + half_ulp, 1 - half_ulp, 0x1p-60, 0});
  Values exact = x, kept = x;
  for (double& value : exact) value = std::min(2 * std::min(value, 1 - value), 1 - half_ulp);
  for (double& value : kept) value = wrapped(2 * value);
  const auto measured = MEASURE(tent, x);
  expect_each({measured.call, measured.exactly(x.size(), any_number)},
              {.exact = exact,
               .tolerance = {2 * half_ulp},
               .because = "1 - |2x - 1| is 2x up to 1/2, and 2 - 2x above",
               .suspects = {{kept, "this is 2x modulo 1, which jumps at 1/2: fold instead"_likely}},
               .rule = "1 - |2x - 1|"});
  measured.exactly(x.size(), unit);  // 1/2 becomes the largest double below 1
}

/// Sums and differences below 2 have a rounding error of at most 2^-53: two for each of two points,
/// and five more in the comparison. Twice that.
constexpr double shift_tolerance = 18 * half_ulp;

/// Point i moved by the same vector as point 0, modulo 1, to a place in the unit cube.
bool moves_alike(View from, View to, std::size_t i) {
  const double shift = to[0] - from[0], off = std::remainder(to[i] - from[i] - shift, 1.0);
  return to[i] >= 0 && to[i] < 1 && std::abs(off) <= shift_tolerance;
}

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
      if (moves_alike(from, to, i)) continue;
      const Values pair{from[0], from[i]};  // most often they fail alone: easier to repeat
      const auto alone = MEASURE(random_shift, pair, 1, 1, seed);
      const View moved = alone.exactly(2, any_number);
      const bool is_pair = !moves_alike(pair, moved, 1);
      const View before = is_pair ? View(pair) : from, after = is_pair ? moved : to;
      const std::size_t at = is_pair ? 1 : i;
      expect_that(
          false,
          fmt::format("{}: coordinate {} of point {} went from {:.6g} to {:.17g}, that of point 0 "
                      "from {:.6g} to {:.17g}",
                      is_pair ? alone.call : measured.call, is_pair ? 0 : k % dims, at, before[at],
                      after[at], before[0], after[0]),
          "all points move by the same vector, modulo 1",
          "the differences of points do not change, modulo 1",
          "add one random number per axis, not one per point; subtract 1 if the sum is 1 or more");
    }
    shifts.values.push_back(std::min(shift, 1 - half_ulp));
  }
  pass();
  return shifts;
}

/// Two points, each with an error of 4 * 2^-53, and two rounded results of the judge.
constexpr double lattice_tolerance = 10 * half_ulp;

/// i z / n modulo 1.
double multiple(Count i, Count z, Count n) {
  return static_cast<double>(i * z % n) / static_cast<double>(n);
}

/// What well-known mistakes have for i z / n modulo 1.
Likely lattice_hint(View x, Count z) {
  const auto explains = [&](auto place, double within) {
    for (Count i = 0; i < x.size(); ++i) {
      if (std::abs(std::remainder(x[i] - x[0] - place(i), 1.0)) > within) return false;
    }
    return true;
  };
  const Count n = x.size();
  if (explains([=](Count i) { return multiple(i, 1, n); }, lattice_tolerance)) {
    return "this is i / N on every axis: multiply i by lattice_vector[d] first"_likely;
  }
  if (explains([=](Count i) { return multiple(i * z & 0xffffffffu, 1, n); }, lattice_tolerance)) {
    return "i z needs more than 32 bits"_likely;
  }
  if (explains([=](Count i) { return multiple(i, z, n); }, 1e-6)) {
    return "rounding errors: compute i z modulo N in integers, and divide once"_likely;
  }
  return {};
}

Values check_lattice(Count n, Count dims, const std::vector<Count>& seeds) {
  const auto measured = MEASURE(lattice, n, dims, seeds);
  const View got = measured.exactly(seeds.size() * n * dims, any_number);
  Values shifts;
  for (std::size_t k = 0; k < seeds.size() * dims; ++k) {
    const View x = got.subspan(k * n, n);
    const Count z = lattice_vector[k % dims];
    for (Count i = 0; i < n; ++i) {
      const double exact = wrapped(x[0] + multiple(i, z, n));
      const bool holds =
          x[i] >= 0 && x[i] < 1 && std::abs(std::remainder(x[i] - exact, 1.0)) <= lattice_tolerance;
      if (holds) continue;
      expect_that(
          false,
          fmt::format("{}: coordinate {} of point {} = {:.17g}, of point 0 = {:.17g}",
                      measured.call, k % dims, i, x[i], x[0]),
          fmt::format("{:.17g}, which is {} * {} / {} from point 0, modulo 1", exact, i, z, n),
          "i z_d / N modulo 1, and one shift for all points of an axis", "", lattice_hint(x, z));
    }
    shifts.push_back(x[0]);
  }
  pass();
  return shifts;
}

}  // namespace
}  // namespace mc::checks
