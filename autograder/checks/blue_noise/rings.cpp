// 4.5

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "checks/blue_noise/point_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

/// Sums and counts over rings.
struct Rings {
  Values sum, count;
  explicit Rings(std::size_t rings) : sum(rings), count(rings) {}
  void add(std::size_t ring, double power) {
    if (ring < sum.size()) sum[ring] += power, ++count[ring];
  }
  /// Their quotients; NaN for ring 0.
  Values means(const Values& over) const {
    Values all{nan};
    for (std::size_t r = 1; r < sum.size(); ++r) all.push_back(sum[r] / over[r]);
    return all;
  }
};

CHECK_CASE("4.5 the mean over each ring", "[4.5][main][points:5]") {
  Rng rng = check_rng();
  for (const int kmax : {5, 2, 24, 3, 63, 129, 1}) {
    const auto side = static_cast<std::size_t>(2 * kmax + 1), last = static_cast<std::size_t>(kmax);
    const Values power = uniform_values(rng, side * side, 0, 3);
    Rings rounded(last + 1), cut(last + 1), half(last + 1), with_corners(last + 1);
    std::size_t i = 0;
    for (int ky = -kmax; ky <= kmax; ++ky) {
      for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
        const double k = std::hypot(kx, ky);  // k + 1/2 has no whole square: never halfway
        const auto ring = static_cast<std::size_t>(std::lround(k));
        rounded.add(ring, power[i]);
        cut.add(static_cast<std::size_t>(k), power[i]);
        if (ky >= 0) half.add(ring, power[i]);
        with_corners.add(std::min(ring, last), power[i]);
      }
    }
    Values circles(last + 1), tolerance(last + 1);
    for (std::size_t r = 1; r <= last; ++r) {
      circles[r] = 2 * std::numbers::pi * static_cast<double>(r);
      tolerance[r] = (rounded.count[r] + 2) * eps * rounded.sum[r] / rounded.count[r];
    }
    Comparison rings{
        .exact = rounded.means(rounded.count),
        .tolerance = tolerance,
        .because =
            "n additions of positive numbers lose n eps at most; the power at k = 0 is N "
            "for any points, so ring 0 is NaN",
        .suspects =
            {{cut.means(cut.count), "abs(k) is cut here: round it to the nearest ring"},
             {rounded.means(Values(last + 1, 1)),
              "this is the sum over the ring: its mean is asked for"},
             {rounded.means(circles),
              "this is the sum over 2 pi r: divide by how many (kx, ky) there are in the ring"},
             {half.means(half.count), "this is the mean over ky >= 0 alone"},
             {with_corners.means(with_corners.count),
              "the corners are in the last ring: they belong to none"}},
        .otherwise =
            "the mean of all (kx, ky) whose sqrt(kx^2 + ky^2) rounds to this ring, of "
            "negative k too"};
    Curve mean_left{rings.exact,
                    "the power at k = 0 is still in here: ring 0 has no meaning, so NaN"};
    mean_left.values[0] = power[side * side / 2];
    rings.suspects.push_back(mean_left);
    const auto measured = MEASURE(radial_power, power, kmax);
    expect_each({measured.call, measured.exactly(last + 1, any_number)}, rings);
  }
}

std::vector<InvalidCall> wrong_rings() {
  std::vector<InvalidCall> calls;
  for (const int kmax : {0, -1, -2, std::numeric_limits<int>::min()}) {
    calls.push_back(
        {MEASURE_OUTCOME(radial_power, Values(1, 1.0), kmax), "kmax", "kmax is 1 at least"});
  }
  calls.push_back({MEASURE_OUTCOME(radial_power, Values(9, 1.0), -2), "kmax",
                   "kmax is 1 at least; (2 kmax + 1)^2 is 9 all the same"});
  for (const std::size_t size : {0u, 9u, 24u, 26u, 49u}) {
    calls.push_back({MEASURE_OUTCOME(radial_power, Values(size, 1.0), 2), "power",
                     "there are (2 kmax + 1)^2 = 25 values of k"});
  }
  return calls;
}

CHECK_CASE("4.5 misuse of radial_power is refused", "[4.5][edge][points:2]") {
  expect_refused(wrong_rings());
}

CHECK_CASE("4.5 a refusal names the argument", "[4.5][edge][points:1]") {
  expect_argument_named(wrong_rings());
}

}  // namespace
}  // namespace mc::checks
