// 4.6

#include <algorithm>

#include <fmt/format.h>

#include "checks/blue_noise/point_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

/// A point's coordinates, in an order that does not depend on rounding by less than 1e-9.
void sort_by_place(std::vector<std::array<double, 2>>& points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::abs(a[1] - b[1]) > 1e-9 ? a[1] < b[1] : a[0] < b[0];
  });
}

/// x and y of points by their places.
Values by_place(std::vector<std::array<double, 2>> points) {
  sort_by_place(points);
  Values all;
  for (const auto& point : points) all.insert(all.end(), point.begin(), point.end());
  return all;
}

CHECK_CASE("4.6 copies lie side by side", "[4.6][main][points:8]") {
  Rng rng = check_rng();
  for (const auto& [n, copies] : {std::pair<std::size_t, int>{20, 2},
                                  {20, 3},
                                  {7, 7},
                                  {65, 16},
                                  {1, 100},
                                  {129, 3},
                                  {20, 1},
                                  {1, 1},
                                  {2, 5}}) {
    Points pattern = uniform_points(rng, n);
    pattern.x[0] = below_one;
    if (n > 3) pattern.y[1] = below_one, pattern.x[2] = pattern.y[3] = 0;
    const auto repeats = static_cast<std::size_t>(copies);
    const auto measured = MEASURE(tile, pattern.x, pattern.y, copies);
    const Points& points = measured.exactly(repeats * repeats * n, unit);
    std::vector<std::array<double, 2>> got, exact, in_one_place;
    for (std::size_t i = 0; i < points.x.size(); ++i) got.push_back({points.x[i], points.y[i]});
    for (int row = 0; row < copies; ++row) {
      for (int column = 0; column < copies; ++column) {
        for (std::size_t p = 0; p < n; ++p) {
          const double x = pattern.x[p], y = pattern.y[p];
          exact.push_back({(column + x) / copies, (row + y) / copies});
          in_one_place.push_back({x / copies, y / copies});
        }
      }
    }
    expect_each(
        {measured.call, by_place(got)},
        {.exact = by_place(exact),
         .tolerance = {eps},  // the sum is rounded to eps copies / 2, the quotient to eps / 4
         .because = "a point of the copy (i, j) lies at ((i + x) / copies, (j + y) / "
                    "copies): every copy is the pattern at 1/copies of its size",
         .suspects = {{by_place(in_one_place),
                       "all copies are in one place: i / copies of "
                       "two whole numbers is 0"}},
         .otherwise = "the copies are not alike: nothing is turned, mirrored or moved",
         .name = [&](std::size_t i) {
           return fmt::format("{}: {} of the {}th point, row by row", measured.call,
                              i % 2 == 0 ? "x" : "y", i / 2);
         }});
  }
}

std::vector<InvalidCall> wrong_tiles() {
  std::vector<InvalidCall> calls;
  for (const int copies : {0, -1, -7}) {
    calls.push_back(
        {MEASURE_OUTCOME(tile_of, 3, 2, copies), "copies", "there is one copy at least"});
  }
  calls.push_back({MEASURE_OUTCOME(tile_of, 0, 2, 3), "pattern", "there are no points"});
  for (const std::uint64_t dims : {0u, 1u, 3u}) {
    calls.push_back({MEASURE_OUTCOME(tile_of, 3, dims, 2), "pattern",
                     "a pattern of the square has two dimensions"});
  }
  return calls;
}

CHECK_CASE("4.6 misuse of tile is refused", "[4.6][edge][points:1]") {
  expect_refused(wrong_tiles());
}

CHECK_CASE("4.6 a refusal names the argument", "[4.6][edge][points:1]") {
  expect_argument_named(wrong_tiles());
}

}  // namespace
}  // namespace mc::checks
