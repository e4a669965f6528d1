// 4.1

#include <cmath>

#include <fmt/format.h>

#include "checks/blue_noise/point_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"

namespace mc::checks {

CHECK_CASE("4.1 the distance to the nearest copy", "[4.1][main][points:6]") {
  Rng rng = check_rng();
  Points a, b;
  const auto ask = [&](double ax, double ay, double bx, double by) {
    a.x.push_back(ax), a.y.push_back(ay);
    b.x.push_back(bx), b.y.push_back(by);
  };
  // First where both ways lead across an edge and all mistakes differ; then anywhere; then where
  // ways are equally long, points equal, or coordinates at the ends of their range.
  for (int i = 0; i < 20; ++i) {
    const bool right = i % 2 == 0, top = i % 4 < 2;
    const double low_x = uniform(rng, 0, 0.2), low_y = uniform(rng, 0, 0.2);
    const double high_x = uniform(rng, 0.75, 1), high_y = uniform(rng, 0.75, 1);
    ask(right ? high_x : low_x, top ? high_y : low_y, right ? low_x : high_x, top ? low_y : high_y);
  }
  for (int i = 0; i < 400; ++i) ask(uniform(rng), uniform(rng), uniform(rng), uniform(rng));
  const double edges[] = {0, below_one, 0.5, 0.25, 0.75, uniform(rng), 1e-300, eps};
  for (const double x : edges) {
    for (const double y : edges) ask(x, y, y, uniform(rng) < 0.5 ? x : 0);
  }
  for (int i = 0; i < 20; ++i) {
    const double x = uniform(rng, 0, 0.5), y = uniform(rng, 0, 0.5);
    ask(x, y, x, y);
    ask(x, y, x + 0.5, y + (i % 2 == 0 ? 0.5 : 0));
  }
  Comparison distances{
      .exact = {},
      .tolerance = {},
      .because = "coordinates are rounded to eps / 2, differences too",
      .suspects = {{{},
                    "this is the distance within the square: the way across an edge is shorter"},
                   {{}, "this is the distance: its square is asked for"},
                   {{}, "x goes round the torus, y does not"},
                   {{}, "y goes round the torus, x does not"},
                   {{}, "this is the sum of both ways: their squares are added"}},
      .otherwise = "along each axis, take the shorter of |difference| and 1 - |difference|",
      .name =
          [&](std::size_t i) {
            return fmt::format("from ({}, {}) to ({}, {})", a.x[i], a.y[i], b.x[i], b.y[i]);
          },
      .separate_calls = true};
  for (std::size_t i = 0; i < a.x.size(); ++i) {
    const long double dx = static_cast<long double>(a.x[i]) - b.x[i];
    const long double dy = static_cast<long double>(a.y[i]) - b.y[i];
    const long double short_x = dx - std::round(dx), short_y = dy - std::round(dy);
    const auto squared = [](long double x, long double y) {
      return static_cast<double>(x * x + y * y);
    };
    const double exact = squared(short_x, short_y);
    // Each shortest way is rounded twice, by eps / 4 at most, and so is wrong by eps / 2: its
    // square by eps |way|, both by 1.5 eps times the distance; the rest is relative to its square.
    distances.exact.push_back(exact);
    distances.tolerance.push_back(4 * eps * std::sqrt(exact) + eps * eps);
    const double values[] = {squared(dx, dy), std::sqrt(exact), squared(short_x, dy),
                             squared(dx, short_y),
                             static_cast<double>(std::abs(short_x) + std::abs(short_y))};
    for (std::size_t s = 0; s < 5; ++s) distances.suspects[s].values.push_back(values[s]);
  }
  const auto measured = MEASURE(toroidal_distances_squared, a.x, a.y, b.x, b.y);
  expect_each({measured.call, measured.exactly(a.x.size(), any_number)}, distances);
}

}  // namespace mc::checks
