// 4.1

#include <cmath>

#include <fmt/format.h>

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"

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
                   {{}, "this is the distance: its square is asked for"},
                   {{}, "x goes round the torus, y does not"},
                   {{}, "y goes round the torus, x does not"},
                   {{}, "this is the sum of both ways: their squares are added"}},
      .otherwise = "along each axis, take the shorter of |difference| and 1 - |difference|",
      .name =
          [&, &a = a, &b = b](std::size_t i) {
            return fmt::format("from ({}, {}) to ({}, {})", a.x[i], a.y[i], b.x[i], b.y[i]);
          },
      .separate_calls = true};
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

}  // namespace
}  // namespace mc::checks
