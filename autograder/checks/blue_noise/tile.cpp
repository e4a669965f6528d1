// 4.6

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

/// Points by their places, in an order that does not depend on rounding by less than 1e-9: y and x
/// of each.
Values by_place(const Points& points) {
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < points.x.size(); ++i) all.emplace_back(points.y[i], points.x[i]);
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::abs(a.first - b.first) > 1e-9 ? a.first < b.first : a.second < b.second;
  });
  Values values;
  for (const auto& [y, x] : all) values.insert(values.end(), {y, x});
  return values;
}

/// Copies of a pattern at 1/copies of its size, copy (i, j) at (i, j) * step / copies.
Values tiled(const Points& pattern, int copies, int step) {
  Points all;
  for (int row = 0; row < copies; ++row) {
    for (int column = 0; column < copies; ++column) {
      for (std::size_t p = 0; p < pattern.x.size(); ++p) {
        all.x.push_back((step * column + pattern.x[p]) / copies);
        all.y.push_back((step * row + pattern.y[p]) / copies);
      }
    }
  }
  return by_place(all);
}

CHECK_CASE("4.6 copies lie side by side", "[4.6][main][points:8]") {
  Rng rng = check_rng();
  const std::pair<std::size_t, int> cases[] = {{20, 2},  {20, 3}, {7, 7},  {65, 33}, {1, 100},
                                               {129, 3}, {20, 1}, {3, 33}, {1, 1},   {2, 5}};
  for (const auto& [n, copies] : cases) {
    Points pattern = uniform_points(rng, n);
    pattern.x[0] = below_one;
    if (n > 3) pattern.y[1] = below_one, pattern.x[2] = pattern.y[3] = 0;
    const auto repeats = static_cast<std::size_t>(copies);
    const auto measured = MEASURE(tile, pattern.x, pattern.y, copies);
    const Values got = by_place(measured.exactly(repeats * repeats * n, unit));
    expect_each(
        {measured.call, got},
        {.exact = tiled(pattern, copies, 1),
         .tolerance = {eps},  // the sum is rounded to eps copies / 2, the quotient to eps / 4
         .because =
             "a point of the copy (i, j) lies at ((i + x) / copies, (j + y) / copies): every "
             "copy is the pattern at 1/copies of its size",
         .suspects = {{tiled(pattern, copies, 0),
                       "all copies are in one place: i / copies of two whole numbers is 0"}},
         .otherwise = "the copies are not alike: nothing is turned, mirrored or moved",
         .name = [&call = measured.call](std::size_t i) {
           return fmt::format("{}: {} of the {}th point, row by row", call, i % 2 == 0 ? "y" : "x",
                              i / 2);
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

REFUSAL_CASES("4.6", "misuse of tile is refused", "1", "a refusal names the argument", "1",
              wrong_tiles())

}  // namespace
}  // namespace mc::checks
