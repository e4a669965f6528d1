// alternative: darts on the free cells of a grid, in a list that is swept again and again until
// each has had many
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"
#undef poisson_disk

namespace mc {

/// Cells of radius / sqrt(2) that hold no point yet get darts in turn, sweep after sweep; one that
/// has had 72 without a hit is given up. The order of a sweep is shuffled.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius > 0 && radius >= 1e-5)) return right_poisson_disk(radius, rng);
  const int side = std::max(1, static_cast<int>(std::ceil(std::numbers::sqrt2 / radius)));
  std::vector<Point2> in_cell(static_cast<std::size_t>(side) * side, Point2{-1, -1});
  std::vector<std::uint32_t> open(in_cell.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = static_cast<std::uint32_t>(i);
  const int reach = std::min(side, static_cast<int>(std::ceil(radius * side)));
  const auto fits = [&](Point2 p, int i, int j) {
    for (int dj = -reach; dj <= reach; ++dj) {
      for (int di = -reach; di <= reach; ++di) {
        const int row = (j + dj + side) % side, column = (i + di + side) % side;
        const Point2 q = in_cell[static_cast<std::size_t>(row) * side + column];
        if (q.x >= 0 && toroidal_distance_squared(p, q) < radius * radius) return false;
      }
    }
    return true;
  };
  std::vector<Point2> points;
  for (int sweep = 0; sweep < 24 && !open.empty(); ++sweep) {
    for (std::size_t k = open.size(); k > 1; --k) std::swap(open[k - 1], open[rng() % k]);
    std::size_t left = 0;
    for (const std::uint32_t cell : open) {
      const int i = static_cast<int>(cell) % side, j = static_cast<int>(cell) / side;
      bool hit = false;
      for (int darts = sweep < 8 ? 1 : 4; darts > 0 && !hit; --darts) {
        const Point2 p{std::min((i + uniform(rng)) / side, 1 - 0x1p-53),
                       std::min((j + uniform(rng)) / side, 1 - 0x1p-53)};
        hit = fits(p, i, j);
        if (hit) in_cell[cell] = p, points.push_back(p);
      }
      if (!hit) open[left++] = cell;
    }
    open.resize(left);
  }
  PointSet set(points.size(), 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    set.column(0)[i] = points[i].x;
    set.column(1)[i] = points[i].y;
  }
  return set;
}

}  // namespace mc
