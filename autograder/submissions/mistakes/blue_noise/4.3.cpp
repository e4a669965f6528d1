// Mistakes in task 4.3.
#include "blue_noise.hpp"

#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

// mistake: places new points only on the edge of an existing disk
// caught by: 4.3 Poisson disks are blue
// hint: too regular
namespace mc::at_the_rim {
/// Bridson 2007, on the torus: new points around old ones, between one radius away.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);
  const auto side = std::max<std::size_t>(1, static_cast<std::size_t>(1 / radius));
  std::vector<std::vector<Point2>> cells(side * side);
  const auto cell = [&](double at) {
    return std::min(side - 1, static_cast<std::size_t>(at * static_cast<double>(side)));
  };
  const auto fits = [&](Point2 p) {
    for (std::size_t dj = 0; dj < 3; ++dj) {
      for (std::size_t di = 0; di < 3; ++di) {
        const std::size_t row = (cell(p.y) + dj + side - 1) % side;
        for (const Point2& q : cells[row * side + (cell(p.x) + di + side - 1) % side]) {
          if (toroidal_distance_squared(p, q) < radius * radius) return false;
        }
      }
    }
    return true;
  };
  std::vector<Point2> points, active;
  const auto add = [&](Point2 p) {
    cells[cell(p.y) * side + cell(p.x)].push_back(p);
    points.push_back(p);
    active.push_back(p);
  };
  add(uniform_point(rng));
  while (!active.empty()) {
    const auto i = static_cast<std::size_t>(uniform(rng) * static_cast<double>(active.size()));
    const Point2 centre = active[i];
    bool found = false;
    for (int k = 0; k < 300 && !found; ++k) {
      const double away = radius * (1 + 1e-9);
      const double angle = 2 * std::numbers::pi * uniform(rng);
      Point2 p{centre.x + away * std::cos(angle), centre.y + away * std::sin(angle)};
      p = {p.x - std::floor(p.x), p.y - std::floor(p.y)};
      found = p.x < 1 && p.y < 1 && fits(p);
      if (found) add(p);
    }
    if (!found) {
      active[i] = active.back();
      active.pop_back();
    }
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}
}  // namespace mc::at_the_rim

// mistake: uses cells as wide as the radius, which can hold two points but store only the last
// caught by: 4.3 no two points are closer
// hint: it must not have room for two
namespace mc::cells_of_the_radius {
/// Darts, and a grid whose cells remember one point each; `reach` cells on each side are looked at.
static PointSet darts_on_grid(double radius, Rng& rng, int side, int reach) {
  std::vector<Point2> cells(static_cast<std::size_t>(side) * side, Point2{-1, -1}), points;
  const auto cell = [&](int column, int row) -> Point2& {
    const int i = (column % side + side) % side, j = (row % side + side) % side;
    return cells[static_cast<std::size_t>(j) * side + i];
  };
  for (std::size_t misses = 0; misses < 1000 + 30 * points.size();) {
    const Point2 dart = uniform_point(rng);
    const int column = static_cast<int>(dart.x * side), row = static_cast<int>(dart.y * side);
    bool fits = true;
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        const Point2& near = cell(column + di, row + dj);
        fits = fits && (near.x < 0 || toroidal_distance_squared(dart, near) >= radius * radius);
      }
    }
    misses = fits ? 0 : misses + 1;
    if (!fits) continue;
    if (static_cast<double>(points.size()) > 2 / radius / radius) break;  // it forgets, and goes on
    cell(column, row) = dart;
    points.push_back(dart);
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);

  return darts_on_grid(radius, rng, std::max(1, static_cast<int>(1 / radius)), 1);
}
}  // namespace mc::cells_of_the_radius

// mistake: rounds the number of cells down, so a cell can hold two points but stores only the last
// caught by: 4.3 no two points are closer
// hint: it must not have room for two
namespace mc::cells_rounded_down {
/// Darts, and a grid whose cells remember one point each; `reach` cells on each side are looked at.
static PointSet darts_on_grid(double radius, Rng& rng, int side, int reach) {
  std::vector<Point2> cells(static_cast<std::size_t>(side) * side, Point2{-1, -1}), points;
  const auto cell = [&](int column, int row) -> Point2& {
    const int i = (column % side + side) % side, j = (row % side + side) % side;
    return cells[static_cast<std::size_t>(j) * side + i];
  };
  for (std::size_t misses = 0; misses < 1000 + 30 * points.size();) {
    const Point2 dart = uniform_point(rng);
    const int column = static_cast<int>(dart.x * side), row = static_cast<int>(dart.y * side);
    bool fits = true;
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        const Point2& near = cell(column + di, row + dj);
        fits = fits && (near.x < 0 || toroidal_distance_squared(dart, near) >= radius * radius);
      }
    }
    misses = fits ? 0 : misses + 1;
    if (!fits) continue;
    if (static_cast<double>(points.size()) > 2 / radius / radius) break;  // it forgets, and goes on
    cell(column, row) = dart;
    points.push_back(dart);
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);

  const int side = std::max(1, static_cast<int>(std::numbers::sqrt2 / radius));
  return darts_on_grid(radius, rng, side, 2);
}
}  // namespace mc::cells_rounded_down

// mistake: compares each dart with all points
// caught by: 4.7 the cost of Poisson disks is linear in their number
// hint: each new point is compared with all others
// limit: time
namespace mc::darts_compared_with_all {
// The right points, after looking at all pairs of them for every try that made them.
PointSet poisson_disk(double radius, Rng& rng) {
  PointSet points = right_poisson_disk(radius, rng);
  const auto x = points.column(0), y = points.column(1);
  double closest = 1;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t tries = 0; tries < 30; ++tries) {
      for (std::size_t p = 0; p < x.size(); ++p) {
        if (p != i) {
          closest = std::min(closest, toroidal_distance_squared({x[i], y[i]}, {x[p], y[p]}));
        }
      }
    }
  }
  if (x.size() > 1 && closest < radius * radius / 2) x[0] = 0;
  return points;
}
}  // namespace mc::darts_compared_with_all

// mistake: throws more darts per point as the number of points grows
// caught by: 4.7 the cost of Poisson disks is linear in their number
// hint: hit its last gaps rarely
namespace mc::darts_for_each_pair {
/// Bridson 2007, on the torus: new points around old ones, between one and two radii away.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);
  const auto side = std::max<std::size_t>(1, static_cast<std::size_t>(1 / radius));
  std::vector<std::vector<Point2>> cells(side * side);
  const auto cell = [&](double at) {
    return std::min(side - 1, static_cast<std::size_t>(at * static_cast<double>(side)));
  };
  const auto fits = [&](Point2 p) {
    for (std::size_t dj = 0; dj < 3; ++dj) {
      for (std::size_t di = 0; di < 3; ++di) {
        const std::size_t row = (cell(p.y) + dj + side - 1) % side;
        for (const Point2& q : cells[row * side + (cell(p.x) + di + side - 1) % side]) {
          if (toroidal_distance_squared(p, q) < radius * radius) return false;
        }
      }
    }
    return true;
  };
  std::vector<Point2> points, active;
  const auto add = [&](Point2 p) {
    cells[cell(p.y) * side + cell(p.x)].push_back(p);
    points.push_back(p);
    active.push_back(p);
  };
  add(uniform_point(rng));
  while (!active.empty()) {
    const auto i = static_cast<std::size_t>(uniform(rng) * static_cast<double>(active.size()));
    const Point2 centre = active[i];
    bool found = false;
    for (int k = 0; k < 60 && !found; ++k) {
      const double away = radius * std::sqrt(1 + 3 * uniform(rng));
      const double angle = 2 * std::numbers::pi * uniform(rng);
      Point2 p{centre.x + away * std::cos(angle), centre.y + away * std::sin(angle)};
      p = {p.x - std::floor(p.x), p.y - std::floor(p.y)};
      found = p.x < 1 && p.y < 1 && fits(p);
      if (found) add(p);
    }
    if (!found) {
      active[i] = active.back();
      active.pop_back();
    }
  }
  // What the rings have missed: as many darts as points, ten times over, and again after each hit.
  for (bool again = true; again;) {
    again = false;
    for (std::size_t darts = 500 + points.size() * points.size() / 300; darts > 0; --darts) {
      const Point2 dart = uniform_point(rng);
      if (!fits(dart)) continue;
      add(dart);
      again = points.size() < 200;
    }
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}
}  // namespace mc::darts_for_each_pair

// mistake: measures the distance within the square, not across its edges
// caught by: 4.3 no two points are closer, 4.3 the pattern is nearly maximal
// caught by: 4.3 Poisson disks are blue, 4.3 a radius too large
// hint: close only across an edge
namespace mc::edges_ignored {
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);
  std::vector<Point2> points;
  const auto fits = [&](Point2 dart) {
    for (const Point2& p : points) {
      if (std::hypot(dart.x - p.x, dart.y - p.y) < radius) return false;
    }
    return true;
  };
  for (int misses = 0; misses < 100;) {
    const Point2 dart = uniform_point(rng);
    if (fits(dart)) {
      points.push_back(dart);
      misses = 0;
    } else {
      ++misses;
    }
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}
}  // namespace mc::edges_ignored

// mistake: searches the eight cells around a point, in a grid whose cells are too narrow for that
// caught by: 4.3 no two points are closer
// hint: is each new point compared with all near it
namespace mc::eight_cells_around {
/// Darts, and a grid whose cells remember one point each; `reach` cells on each side are looked at.
static PointSet darts_on_grid(double radius, Rng& rng, int side, int reach) {
  std::vector<Point2> cells(static_cast<std::size_t>(side) * side, Point2{-1, -1}), points;
  const auto cell = [&](int column, int row) -> Point2& {
    const int i = (column % side + side) % side, j = (row % side + side) % side;
    return cells[static_cast<std::size_t>(j) * side + i];
  };
  for (std::size_t misses = 0; misses < 1000 + 30 * points.size();) {
    const Point2 dart = uniform_point(rng);
    const int column = static_cast<int>(dart.x * side), row = static_cast<int>(dart.y * side);
    bool fits = true;
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        const Point2& near = cell(column + di, row + dj);
        fits = fits && (near.x < 0 || toroidal_distance_squared(dart, near) >= radius * radius);
      }
    }
    misses = fits ? 0 : misses + 1;
    if (!fits) continue;
    if (static_cast<double>(points.size()) > 2 / radius / radius) break;  // it forgets, and goes on
    cell(column, row) = dart;
    points.push_back(dart);
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);

  return darts_on_grid(radius, rng, static_cast<int>(std::ceil(std::numbers::sqrt2 / radius)), 1);
}
}  // namespace mc::eight_cells_around

// mistake: starts each pattern in the middle of the square
// caught by: 4.3 no two points are closer, 4.3 a radius too large for two
// hint: the first point of a set is as random as any other
namespace mc::first_point_in_the_middle {
/// Darts, and a grid whose cells remember one point each; `reach` cells on each side are looked at.
static PointSet darts_on_grid(double radius, Rng& rng, int side, int reach) {
  std::vector<Point2> cells(static_cast<std::size_t>(side) * side, Point2{-1, -1}), points;
  const auto cell = [&](int column, int row) -> Point2& {
    const int i = (column % side + side) % side, j = (row % side + side) % side;
    return cells[static_cast<std::size_t>(j) * side + i];
  };
  for (std::size_t misses = 0; misses < 2000 + 30 * points.size();) {
    const Point2 dart = points.empty() ? Point2{0.5, 0.5} : uniform_point(rng);
    const int column = static_cast<int>(dart.x * side), row = static_cast<int>(dart.y * side);
    bool fits = true;
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        const Point2& near = cell(column + di, row + dj);
        fits = fits && (near.x < 0 || toroidal_distance_squared(dart, near) >= radius * radius);
      }
    }
    misses = fits ? 0 : misses + 1;
    if (!fits) continue;
    if (static_cast<double>(points.size()) > 2 / radius / radius) break;  // it forgets, and goes on
    cell(column, row) = dart;
    points.push_back(dart);
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);

  return darts_on_grid(radius, rng, static_cast<int>(std::ceil(std::numbers::sqrt2 / radius)), 2);
}
}  // namespace mc::first_point_in_the_middle

// mistake: draws from a copy of the generator, so every pattern is the same
// caught by: 4.3 no two points are closer, 4.3 the pattern is nearly maximal
// caught by: 4.3 Poisson disks are blue, 4.3 a radius too large
// hint: draw from the generator that is handed in
namespace mc::generator_of_its_own {
PointSet poisson_disk(double radius, Rng& rng) {
  Rng copy = rng;
  return right_poisson_disk(radius, copy);
}
}  // namespace mc::generator_of_its_own

// mistake: throws darts until ten in a row miss
// caught by: 4.3 the pattern is nearly maximal, 4.3 Poisson disks are blue
// hint: some misses in a row are no proof
namespace mc::gives_up_early {
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);
  std::vector<Point2> points;
  const auto fits = [&](Point2 dart) {
    for (const Point2& p : points) {
      if (toroidal_distance_squared(dart, p) < radius * radius) return false;
    }
    return true;
  };
  for (int misses = 0; misses < 10;) {
    const Point2 dart = uniform_point(rng);
    if (fits(dart)) {
      points.push_back(dart);
      misses = 0;
    } else {
      ++misses;
    }
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}
}  // namespace mc::gives_up_early

// mistake: takes the radius for that of disks that may touch, so points are too close
// caught by: 4.3 no two points are closer, 4.3 a radius too large, 4.3 Poisson disks are blue
// hint: half the radius is kept
namespace mc::half_the_radius {
PointSet poisson_disk(double radius, Rng& rng) {
  return right_poisson_disk(radius >= 2e-5 ? radius / 2 : radius, rng);
}
}  // namespace mc::half_the_radius

// mistake: starts with a radius whose pattern does not fit into memory
// caught by: 4.3 a radius too small for memory
// hint: a text that says how many points
namespace mc::silent_about_memory {
PointSet poisson_disk(double radius, Rng& rng) {
  if (radius < 1e-5) throw std::invalid_argument("radius: too small");
  return right_poisson_disk(radius, rng);
}
}  // namespace mc::silent_about_memory

// mistake: throws darts until 1,000 in a row miss: enough for some hundred points only
// caught by: 4.7 the cost of Poisson disks is linear in their number
// hint: a limit on tries must grow with the number of points
namespace mc::stops_after_a_thousand_misses {
/// Darts, and a grid whose cells remember one point each; `reach` cells on each side are looked at.
static PointSet darts_on_grid(double radius, Rng& rng, int side, int reach) {
  std::vector<Point2> cells(static_cast<std::size_t>(side) * side, Point2{-1, -1}), points;
  const auto cell = [&](int column, int row) -> Point2& {
    const int i = (column % side + side) % side, j = (row % side + side) % side;
    return cells[static_cast<std::size_t>(j) * side + i];
  };
  for (std::size_t misses = 0; misses < 1000;) {
    const Point2 dart = uniform_point(rng);
    const int column = static_cast<int>(dart.x * side), row = static_cast<int>(dart.y * side);
    bool fits = true;
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        const Point2& near = cell(column + di, row + dj);
        fits = fits && (near.x < 0 || toroidal_distance_squared(dart, near) >= radius * radius);
      }
    }
    misses = fits ? 0 : misses + 1;
    if (!fits) continue;
    if (static_cast<double>(points.size()) > 2 / radius / radius) break;  // it forgets, and goes on
    cell(column, row) = dart;
    points.push_back(dart);
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}

PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);

  return darts_on_grid(radius, rng, static_cast<int>(std::ceil(std::numbers::sqrt2 / radius)), 2);
}
}  // namespace mc::stops_after_a_thousand_misses
