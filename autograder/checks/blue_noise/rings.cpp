// 4.5

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "checks/blue_noise/point_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/expect.hpp"

namespace mc::checks {

CHECK_CASE("4.5 the mean over each ring", "[4.5][main][points:5]") {
  Rng rng = check_rng();
  for (const int kmax : {5, 2, 24, 1}) {
    const auto side = static_cast<std::size_t>(2 * kmax + 1);
    const Values power = uniform_values(rng, side * side, 0, 3);
    const auto rings = static_cast<std::size_t>(kmax + 1);
    // Sums and counts of the rings: rounded, cut, and of one half of the plane.
    Values sum(rings), count(rings), cut(2 * rings), cut_count(2 * rings), half(rings),
        half_count(rings);
    double corners = 0, corner_count = 0;
    std::size_t i = 0;
    for (int ky = -kmax; ky <= kmax; ++ky) {
      for (int kx = -kmax; kx <= kmax; ++kx, ++i) {
        const double k = std::hypot(kx, ky);  // k + 1/2 has no whole square: never halfway
        cut[static_cast<std::size_t>(k)] += power[i];
        ++cut_count[static_cast<std::size_t>(k)];
        const auto ring = static_cast<std::size_t>(std::lround(k));
        if (ring < rings) sum[ring] += power[i], ++count[ring];
        if (ring < rings && ky >= 0) half[ring] += power[i], ++half_count[ring];
        if (ring >= rings) corners += power[i], ++corner_count;
      }
    }
    const auto measured = MEASURE(radial_power, power, kmax);
    const Values& got = measured.exactly(rings, any_number);
    for (std::size_t ring = 1; ring < rings; ++ring) {
      const double exact = sum[ring] / count[ring];
      expect_within(
          fmt::format("{}[{}]", measured.call, ring), got[ring], exact,
          (count[ring] + 2) * eps * exact, "n additions of positive numbers lose n eps at most",
          {{{cut[ring] / cut_count[ring], "abs(k) is cut here: round it to the nearest ring"},
            {sum[ring], "this is the sum over the ring: its mean is asked for"},
            {sum[ring] / (2 * std::numbers::pi * static_cast<double>(ring)),
             "this is the sum over 2 pi r: divide by how many (kx, ky) there are in the ring"},
            {half[ring] / half_count[ring], "this is the mean over ky >= 0 alone"},
            {ring + 1 == rings ? (sum[ring] + corners) / (count[ring] + corner_count) : exact,
             "the corners are in the last ring: they belong to none"}},
           "the mean of all (kx, ky) whose sqrt(kx^2 + ky^2) rounds to this ring, of negative k "
           "too"});
    }
    expect_that(std::isnan(got[0]), fmt::format("{}[0] = {}", measured.call, got[0]), "NaN",
                "the power at k = 0 is N for any points, which says nothing about them",
                "the mean of the points is still in here: ring 0 has no meaning, so NaN");
  }
}

CHECK_CASE("4.5 misuse of radial_power is refused", "[4.5][edge][points:2]") {
  for (const int kmax : {0, -1}) {
    expect_refused(MEASURE_OUTCOME(radial_power, Values(1, 1.0), kmax), "kmax is 1 at least");
  }
  for (const std::size_t size : {0u, 9u, 24u, 26u}) {
    expect_refused(MEASURE_OUTCOME(radial_power, Values(size, 1.0), 2),
                   "there are (2 kmax + 1)^2 = 25 values of k");
  }
}

CHECK_CASE("4.5 a refusal names the argument", "[4.5][edge][points:1]") {
  expect_invalid_argument(MEASURE_OUTCOME(radial_power, Values(1, 1.0), 0), "kmax",
                          "kmax is 1 at least");
  expect_invalid_argument(MEASURE_OUTCOME(radial_power, Values(24, 1.0), 2), "power",
                          "there are (2 kmax + 1)^2 = 25 values of k");
}

}  // namespace mc::checks
