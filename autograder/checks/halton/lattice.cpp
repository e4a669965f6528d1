// 5.10: rank-1 lattices, shifted at random, and the tent transform.

#include "5-halton/experiments.hpp"
#include "checks/halton/exact_points.hpp"

namespace mc::checks {
namespace {

/// Two points, each within 4 * 2^-53 of what it should be; the exact difference is rounded, and so
/// is what the point should be by it.
constexpr double lattice_tolerance = 10 * half_ulp;

using Count = std::uint64_t;

/// i z / n modulo 1.
double multiple(Count i, Count z, Count n) {
  return static_cast<double>(i * z % n) / static_cast<double>(n);
}

/// A mistake: where it puts point i of n on an axis with this z.
struct OtherLattice {
  double (*place)(Count i, Count z, Count n);
  std::string hint;
};

std::string lattice_hint(View x, Count z) {
  if (std::any_of(x.begin(), x.end(), [](double one) { return std::isnan(one); })) {
    return never_written;
  }
  const auto explains = [&](auto place, Count by, double within) {
    for (Count i = 0; i < x.size(); ++i) {
      const double off = x[i] - x[0] - place(i, by, x.size());
      if (std::abs(std::remainder(off, 1.0)) > within) return false;
    }
    return true;
  };
  const OtherLattice mistakes[] = {
      {[](Count, Count, Count) { return 0.0; }, "all points are the same on this axis"},
      {[](Count i, Count, Count n) { return multiple(i, 1, n); },
       "this is i / N on every axis: multiply i by lattice_vector[d] first"},
      {[](Count i, Count by, Count n) { return multiple(i, by, n - 1); },
       "N points are multiples of 1 / N, not of 1 / (N - 1)"},
      {[](Count i, Count by, Count n) { return multiple(i * by & 0xffffffffu, 1, n); },
       "i z needs more than 32 bits"}};
  for (const auto& [place, hint] : mistakes) {
    if (explains(place, z, lattice_tolerance)) return hint;
  }
  for (std::size_t d = 0; d < lattice_vector.size(); ++d) {
    if (explains(multiple, lattice_vector[d], lattice_tolerance)) {
      return fmt::format("this is axis {}: they count from 0", d);
    }
  }
  return explains(multiple, z, 1e-6)
             ? "these points are rounded: compute i z modulo N in integers, and divide once; "
               "multiples of a rounded z / N lose as many digits as i z has"
             : "one shift for all points of an axis, and i from 0 to N - 1";
}

/// All points are multiples of z / N from point 0, around the unit cube. Returns the shifts.
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
      expect_that(false,
                  fmt::format("{}: coordinate {} of point {} = {:.17g}, of point 0 = {:.17g}",
                              measured.call, k % dims, i, x[i], x[0]),
                  fmt::format("{:.17g}, {} * {} / {} from point 0, modulo 1", exact, i, z, n),
                  "i z_d / N modulo 1, and one shift for all points of an axis",
                  x[i] < 0 || x[i] >= 1 ? "it left the unit interval: wrap around at 1"
                                        : lattice_hint(x, z));
    }
    shifts.push_back(x[0]);
  }
  pass();
  return shifts;
}

CHECK_CASE("5.10 points of a lattice are multiples of z / N", "[5.10][stretch][needs:5.7][main]") {
  Rng rng = check_rng();
  for (const Count n : {Count{64}, 2 + rng() % 1000}) {
    for (const Count dims : {2u, 1u, 16u}) check_lattice(n, dims, domain::seeds(rng, 2));
  }
}

CHECK_CASE("5.10 lattices of any size", "[5.10][stretch][needs:5.7]") {
  Rng rng = check_rng();
  for (const Count n : domain::sizes(5000, rng)) check_lattice(n, 3, domain::seeds(rng, 1));
  // From N = 65,537 on i z has 33 bits, so that 32 are too few where they are not divided by N.
  for (const Count n : {100'003u, 131'072u}) check_lattice(n, 5, domain::seeds(rng, 1));
}

/// Then each point is uniform in the cube, and every estimate unbiased.
CHECK_CASE("5.10 each axis has its own uniform shift", "[5.10][stretch][needs:5.7]") {
  Rng rng = check_rng();
  const Randomness claim = uniform_shift(
      "a lattice",
      "the shift does not depend on all 64 bits of the seed, or seeds that follow each other give "
      "related shifts");
  for (const auto& seeds :
       {domain::seeds(rng, 3000), domain::in_a_row(rng(), 3000), domain::seeds_by_bit(rng)}) {
    Uniforms shifts{"", 16, check_lattice(1, 16, seeds)};
    shifts.call = fmt::format("lattice(1, 16, {})", shown(seeds));
    shifts.name = [](std::size_t d) { return fmt::format("the shift of axis {}", d); };
    expect_independent_uniforms(shifts, claim);
  }
}

CHECK_CASE("5.10 the tent transform folds the line", "[5.10][stretch]") {
  Rng rng = check_rng();
  Values x = uniform_values(rng, 20, 0, 1);
  x.insert(x.end(), {0.25, 0.75, 0.5 - 0x1p-54, 0.5, 0.5 + half_ulp, 1 - half_ulp, 0x1p-60, 0});
  Values exact = x, kept = x;
  for (double& value : exact) value = std::min(2 * std::min(value, 1 - value), 1 - half_ulp);
  for (double& value : kept) value = wrapped(2 * value);
  const auto measured = MEASURE(tent, x);
  expect_each({measured.call, measured.exactly(x.size(), any_number)},
              {.exact = exact,
               .tolerance = {2 * half_ulp},
               .because = "1 - |2x - 1| is 2x up to 1/2, and 2 - 2x from there on",
               .suspects = {{kept, "this is 2x modulo 1, which jumps at 1/2: fold instead"},
                            {x, "these are the values as they were"}},
               .otherwise = "1 - |2x - 1|"});
  expect_that(measured.exactly(x.size(), unit)[23] < 1, "tent of 1/2 is 1",
              "the largest double below 1", "values lie in [0, 1)", "keep it below 1");
}

CHECK_CASE("5.10 more dimensions than the vector has are refused", "[5.10][stretch][edge]") {
  expect_refused_by_name(
      {{MEASURE_OUTCOME(lattice, 4, 17, {1}), "points|dims", "lattice_vector has 16 numbers"},
       {MEASURE_OUTCOME(lattice, 2, 1000, {1}), "points|dims", "lattice_vector has 16 numbers"}});
}

}  // namespace
}  // namespace mc::checks
