// mistake: throws darts until 1,000 in a row have missed: right for some hundred points
// caught by: 4.7 the cost of Poisson disks is linear in their number
// hint: a limit on tries must grow with the number of points
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

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

}  // namespace mc
