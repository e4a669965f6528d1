// 4.1, 4.6: distances on the torus, and patterns in tiles.

#include "checks/blue_noise/random_sets.hpp"

namespace mc::checks {
namespace {

struct Pairs {
  Points a, b;
  void add(Point2 from, Point2 to) {
    a.x.push_back(from.x), a.y.push_back(from.y);
    b.x.push_back(to.x), b.y.push_back(to.y);
  }
};

/// First pairs whose both ways lead across an edge, where all mistakes differ; then any; then ways
/// equally long, equal points, and coordinates at the ends of their range.
Pairs pairs(Rng& rng) {
  Pairs all;
  for (int i = 0; i < 20; ++i) {
    const double low_x = uniform(rng, 0, 0.2), low_y = uniform(rng, 0, 0.2);
    const double high_x = uniform(rng, 0.75, 1), high_y = uniform(rng, 0.75, 1);
    const bool right = i % 2 == 0, top = i % 4 < 2;
    all.add({right ? high_x : low_x, top ? high_y : low_y},
            {right ? low_x : high_x, top ? low_y : high_y});
  }
  for (int i = 0; i < 400; ++i) {
    all.add({uniform(rng), uniform(rng)}, {uniform(rng), uniform(rng)});
  }
  const double edges[] = {0, below_one, 0.5, 0.25, 0.75, uniform(rng), 1e-300, eps};
  for (const double x : edges) {
    for (const double y : edges) all.add({x, y}, {y, uniform(rng) < 0.5 ? x : 0});
  }
  for (int i = 0; i < 20; ++i) {
    const double x = uniform(rng, 0, 0.5), y = uniform(rng, 0, 0.5);
    all.add({x, y}, {x, y});
    all.add({x, y}, {x + 0.5, y + (i % 2 == 0 ? 0.5 : 0)});
  }
  return all;
}

CHECK_CASE("4.1 the distance to the nearest copy", "[4.1][main][points:6]") {
  Rng rng = check_rng();
  const auto [a, b] = pairs(rng);
  Comparison distances{
      .exact = {},
      .tolerance = {},
      .because = "coordinates are rounded to eps / 2, differences too",
      .suspects = {{{},
                    "this is the distance within the square: the way across an edge is shorter"},
                   {{}, "this is the distance: the task asks for its square"},
                   {{}, "x goes round the torus, y does not"},
                   {{}, "y goes round the torus, x does not"},
                   {{}, "this is the sum of both ways: their squares are added"}},
      .otherwise = "along each axis, take the shorter of |difference| and 1 - |difference|",
      .name =
          [&, &a = a, &b = b](std::size_t i) {
            return fmt::format("from ({}, {}) to ({}, {})", a.x[i], a.y[i], b.x[i], b.y[i]);
          },
      .separate_calls = true,
      .is_tame = true};
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    const long double dx = static_cast<long double>(a.x[i]) - b.x[i];
    const long double dy = static_cast<long double>(a.y[i]) - b.y[i];
    const long double x = dx - std::round(dx), y = dy - std::round(dy);  // the shortest way
    const auto exact = static_cast<double>(x * x + y * y);
    // Each shortest way is rounded twice, by eps / 4 at most, and so is wrong by eps / 2: its
    // square by eps |way|, both by 1.5 eps times the distance; the rest is relative to its square.
    distances.exact.push_back(exact);
    distances.tolerance.push_back(4 * eps * std::sqrt(exact) + eps * eps);
    const long double wrong[] = {dx * dx + dy * dy, std::sqrt(exact), x * x + dy * dy,
                                 dx * dx + y * y, std::abs(x) + std::abs(y)};
    for (std::size_t s = 0; s < std::size(wrong); ++s) {
      distances.suspects[s].values.push_back(static_cast<double>(wrong[s]));
    }
  }
  const auto measured = MEASURE(toroidal_distances_squared, a.x, a.y, b.x, b.y);
  expect_each({measured.call, measured.exactly(a.x.size(), any_number)}, distances);
}

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
        all.x.push_back(std::min((step * column + pattern.x[p]) / copies, below_one));
        all.y.push_back(std::min((step * row + pattern.y[p]) / copies, below_one));
      }
    }
  }
  return by_place(all);
}

/// Tilings of random patterns, of which some points lie `at_the_edge`: at 0 or just below 1.
void judge_tilings(bool at_the_edge) {
  Rng rng = check_rng();
  const std::pair<std::size_t, int> cases[] = {{20, 2},  {20, 3}, {7, 7},  {65, 33}, {1, 100},
                                               {129, 3}, {20, 1}, {3, 33}, {1, 1},   {2, 5}};
  for (const auto& [n, copies] : cases) {
    Points pattern = uniform_points(rng, n);
    if (at_the_edge) {
      pattern.x[0] = below_one;
      if (n > 3) pattern.y[1] = below_one, pattern.x[2] = pattern.y[3] = 0;
    }
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
           return fmt::format("{}: {} of point {}, row by row", call, i % 2 == 0 ? "y" : "x",
                              i / 2);
         }});
  }
}

CHECK_CASE("4.6 copies lie side by side", "[4.6][main][points:7]") {
  judge_tilings(false);
}

CHECK_CASE("4.6 copies of points just below 1 stay below 1", "[4.6][edge][points:1]") {
  judge_tilings(true);
}

std::vector<InvalidCall> wrong_tiles() {
  std::vector<InvalidCall> calls;
  for (const int copies : {0, -1, -7}) {
    calls.push_back(
        {MEASURE_OUTCOME(tile_of, 3, 2, copies), "copies", "there is one copy at least"});
  }
  for (const int copies : {2, 1}) {
    calls.push_back({MEASURE_OUTCOME(tile_of, 0, 2, copies), "pattern", "there are no points"});
    for (const std::uint64_t dims : {0u, 1u, 3u}) {
      calls.push_back({MEASURE_OUTCOME(tile_of, 3, dims, copies), "pattern",
                       "a pattern of the square has two dimensions"});
    }
  }
  return calls;
}

REFUSAL_CASES("4.6", "misuse of tile is refused", "1", "a refusal names the argument", "1",
              wrong_tiles())

}  // namespace
}  // namespace mc::checks
