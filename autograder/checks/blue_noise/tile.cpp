// 4.6

#include <algorithm>

#include <fmt/format.h>

#include "checks/blue_noise/power.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/discs.hpp"
#include "checks/support/expect.hpp"

namespace mc::checks {

CHECK_CASE("4.6 copies lie side by side", "[4.6][main][points:5]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 20;
  for (const int copies : {2, 3, 7, 1}) {
    Points pattern = uniform_points(rng, n);
    pattern.x[0] = below_one;
    pattern.y[1] = below_one;
    pattern.x[2] = pattern.y[3] = 0;
    const auto measured = MEASURE(tile, pattern.x, pattern.y, copies);
    const auto repeats = static_cast<std::size_t>(copies);
    const Points& got = measured.exactly(repeats * repeats * n, unit);
    // The sum of a cell and a coordinate is rounded to eps copies / 2, the quotient to eps / 4.
    std::vector<bool> taken(got.x.size());
    const double seam = least_distance(got.x, got.y);
    const double inside = least_distance(pattern.x, pattern.y) / copies;
    for (int row = 0; row < copies; ++row) {
      for (int column = 0; column < copies; ++column) {
        for (std::size_t p = 0; p < n; ++p) {
          const double x = (column + pattern.x[p]) / copies, y = (row + pattern.y[p]) / copies;
          bool found = false;
          for (std::size_t i = 0; i < taken.size() && !found; ++i) {
            found = !taken[i] && std::abs(got.x[i] - x) <= eps && std::abs(got.y[i] - y) <= eps;
            if (found) taken[i] = true;
          }
          const bool in_one_place =
              copies > 1 && std::all_of(got.x.begin(), got.x.end(),
                                        [=](double value) { return value < 1.0 / copies + eps; });
          expect_that(
              found,
              fmt::format("{}: no point at ({}, {}); the closest two are {} apart", measured.call,
                          x, y, seam),
              fmt::format("point {} of the pattern in column {}, row {}; {} apart", p, column, row,
                          inside),
              "every copy is the pattern at 1/copies of its size, so seams are as its edges are "
              "on the torus",
              in_one_place
                  ? "all copies are in one place: i / copies of two whole numbers is 0"
                  : "a point of the copy (i, j) lies at ((i + x) / copies, (j + y) / copies)");
        }
      }
    }
  }
}

CHECK_CASE("4.6 a tiled pattern has power at multiples only", "[4.6][points:3]") {
  Rng rng = check_rng();
  for (const int copies : {2, 3}) {
    const std::size_t n = 30;
    const int kmax = 3 * copies;
    const Points pattern = uniform_points(rng, n);
    const Spectrum of_pattern = exact_spectrum(pattern.x, pattern.y, 3);
    const auto measured = MEASURE(tile, pattern.x, pattern.y, copies);
    const auto repeats = static_cast<std::size_t>(copies);
    const Points& got = measured.exactly(repeats * repeats * n, unit);
    const Spectrum tiled = exact_spectrum(got.x, got.y, kmax);
    const auto size = static_cast<double>(got.x.size());
    for (int ky = -kmax; ky <= kmax; ++ky) {
      for (int kx = -kmax; kx <= kmax; ++kx) {
        const bool multiple = kx % copies == 0 && ky % copies == 0;
        const double exact =
            multiple ? copies * copies * of_pattern.at(kx / copies, ky / copies) : 0;
        expect_within(fmt::format("{}: power at k = ({}, {})", measured.call, kx, ky),
                      tiled.at(kx, ky), exact, power_tolerance(exact, size, kmax),
                      "waves that fit the copies add up to copies^2 P(k / copies), all others "
                      "cancel; waves are right to 32 (kmax + 1) eps",
                      {{}, "the copies are not alike: nothing is turned, mirrored or moved"});
      }
    }
  }
}

CHECK_CASE("4.6 misuse of tile is refused", "[4.6][edge][points:1]") {
  for (const int copies : {0, -1, -7}) {
    expect_refused(MEASURE_OUTCOME(tile_of, 3, 2, copies), "there is one copy at least");
  }
  expect_refused(MEASURE_OUTCOME(tile_of, 0, 2, 3), "there are no points");
  for (const std::uint64_t dims : {0u, 1u, 3u}) {
    expect_refused(MEASURE_OUTCOME(tile_of, 3, dims, 2),
                   "a pattern of the square has two dimensions");
  }
}

CHECK_CASE("4.6 a refusal names the argument", "[4.6][edge][points:1]") {
  expect_invalid_argument(MEASURE_OUTCOME(tile_of, 3, 2, 0), "copies",
                          "there is one copy at least");
  expect_invalid_argument(MEASURE_OUTCOME(tile_of, 0, 2, 3), "pattern", "there are no points");
  expect_invalid_argument(MEASURE_OUTCOME(tile_of, 3, 3, 2), "pattern",
                          "a pattern of the square has two dimensions");
}

}  // namespace mc::checks
