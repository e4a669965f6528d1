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

void compare_distances(const Pairs& pairs);
/// Tilings of random patterns, with some points `at_the_edge`: at 0 or just below 1.
void judge_tilings(const std::vector<std::pair<std::size_t, int>>& cases, Rng& rng,
                   bool at_the_edge);

CHECK_CASE("4.1 the distance to the nearest copy", "[4.1][main][points:4]") {
  // First pairs that are closest across edges in x and y, for which all mistakes differ; then
  // random ones.
  Pairs all;
  for (int i = 0; i < 20; ++i) {
    const double low_x = uniform(rng, 0, 0.2), low_y = uniform(rng, 0, 0.2);
    const double high_x = uniform(rng, 0.75, 1), high_y = uniform(rng, 0.75, 1);
    const bool right = i % 2 == 0, top = i % 4 < 2;
    all.add({right ? high_x : low_x, top ? high_y : low_y},
            {right ? low_x : high_x, top ? low_y : high_y});
  }
  for (int i = 0; i < 400; ++i) all.add({uniform(rng), uniform(rng)}, {uniform(rng), uniform(rng)});
  compare_distances(all);
}

CHECK_CASE("4.1 equal points and points at the edges", "[4.1][edge][points:2]") {
  Pairs all;
  const double edges[] = {0, below_one, 0.5, 0.25, 0.75, uniform(rng), 1e-300, eps};
  for (const double x : edges) {
    for (const double y : edges) all.add({x, y}, {y, uniform(rng) < 0.5 ? x : 0});
  }
  for (int i = 0; i < 20; ++i) {
    const double x = uniform(rng, 0, 0.5), y = uniform(rng, 0, 0.5);
    all.add({x, y}, {x, y});
    all.add({x, y}, {x + 0.5, y + (i % 2 == 0 ? 0.5 : 0)});
  }
  compare_distances(all);
}

CHECK_CASE("4.6 copies lie side by side", "[4.6][main][points:11]") {
  judge_tilings({{20, 2}, {20, 3}, {7, 7}, {10 + rng() % 50, 4}}, rng, false);
}

CHECK_CASE("4.6 any number of points and copies also at the upper edges", "[4.6][edge][points:3]") {
  for (const bool at_the_edge : {false, true}) {
    judge_tilings({{20, 2},
                   {20, 3},
                   {7, 7},
                   {65, 33},
                   {1, 100},
                   {129, 3},
                   {20, 1},
                   {3, 33},
                   {3, 2},
                   {2, 5},
                   {2, 1},
                   {1, 300},
                   {1, 2},
                   {1, 1}},
                  rng, at_the_edge);
  }
}

void compare_distances(const Pairs& pairs) {
  const auto& [a, b] = pairs;
  Comparison distances{
      .exact = {},
      .tolerance = {},
      .because = "coordinates and differences are rounded to eps / 2",
      .suspects =
          {{{},
            "this is the distance in the square: the distance across an edge is shorter"_likely},
           {{}, "this is the distance: the task asks for its square"_likely},
           {{}, "x wraps around the torus, y does not"_likely},
           {{}, "this is |dx| + |dy|: add the squares"_likely}},
      .rule = "along each axis, take the shorter of |difference| and 1 - |difference|",
      .name =
          [&a = pairs.a, &b = pairs.b](std::size_t i) {
            return fmt::format("from ({}, {}) to ({}, {})", a.x[i], a.y[i], b.x[i], b.y[i]);
          },
      .separate_calls = true,
      .is_tame = true};
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    const long double dx = static_cast<long double>(a.x[i]) - b.x[i];
    const long double dy = static_cast<long double>(a.y[i]) - b.y[i];
    const long double x = dx - std::round(dx), y = dy - std::round(dy);  // the shortest difference
    const auto exact = static_cast<double>(x * x + y * y);
    // Each difference is rounded twice, by at most eps / 4: its error is eps / 2, that of its
    // square eps |difference|, that of the sum 1.5 eps times the distance.
    distances.exact.push_back(exact);
    distances.tolerance.push_back(4 * eps * std::sqrt(exact) + eps * eps);
    const long double wrong[] = {dx * dx + dy * dy, std::sqrt(exact), x * x + dy * dy,
                                 std::abs(x) + std::abs(y)};
    for (std::size_t s = 0; s < std::size(wrong); ++s) {
      distances.suspects[s].values.push_back(static_cast<double>(wrong[s]));
    }
  }
  const auto measured = MEASURE(toroidal_distances_squared, a.x, a.y, b.x, b.y);
  expect_each({measured.call, measured.exactly(a.x.size(), any_number)}, distances);
}

/// y and x of each point, in an order that does not depend on rounding errors below 1e-9.
Values by_place(const Points& points) {
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < points.x.size(); ++i) all.emplace_back(points.y[i], points.x[i]);
  std::ranges::sort(all, [](const auto& a, const auto& b) {
    return std::abs(a.first - b.first) > 1e-9 ? a.first < b.first : a.second < b.second;
  });
  Values values;
  for (const auto& [y, x] : all) values.insert(values.end(), {y, x});
  return values;
}

/// Copies of a pattern, scaled by 1/copies, copy (i, j) at (i, j) * step / copies.
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

void judge_tilings(const std::vector<std::pair<std::size_t, int>>& cases, Rng& rng,
                   bool at_the_edge) {
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
         .because = "a point of the copy (i, j) lies at ((i + x) / copies, (j + y) / copies)",
         .suspects = {{tiled(pattern, copies, 0),
                       "all copies are in one place: i / copies of two integers is 0"_likely}},
         .rule = "do not rotate, mirror or move the pattern; limit only what is rounded up to 1",
         .name =
             [&call = measured.call](std::size_t i) {
               return fmt::format("{}: {} of point {}, row by row", call, i % 2 == 0 ? "y" : "x",
                                  i / 2);
             },
         .is_tame = true});
  }
}

}  // namespace
}  // namespace mc::checks
