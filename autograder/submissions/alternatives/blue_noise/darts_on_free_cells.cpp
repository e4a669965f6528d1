// alternative: darts on the free cells of a grid, in a list that is swept again and again until
// each has had many
#include "blue_noise.hpp"
#define poisson_disk right_poisson_disk
#include "solutions/blue_noise.cpp"

#include <algorithm>
#undef poisson_disk

namespace mc {

constexpr int sweeps = 72;  // a free choice

/// Cells of radius / sqrt(2) that hold no point yet get a dart each in turn, sweep after sweep. The
/// order of a sweep is shuffled.
PointSet poisson_disk(double radius, Rng& rng) {
  if (!(radius >= 1e-5)) return right_poisson_disk(radius, rng);
  radius = std::min(radius, 1.0);
  const int side = static_cast<int>(std::ceil(std::numbers::sqrt2 / radius));
  std::vector<Point2> in_cell(static_cast<std::size_t>(side) * side, Point2{-1, -1});
  std::vector<std::uint32_t> open(in_cell.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = static_cast<std::uint32_t>(i);
  const int reach = std::min(side, static_cast<int>(std::ceil(radius * side)));
  const auto fits = [&](Point2 p, int i, int j) {
    for (int row = j + side - reach; row <= j + side + reach; ++row) {
      for (int column = i + side - reach; column <= i + side + reach; ++column) {
        const Point2 q = in_cell[static_cast<std::size_t>(row % side) * side + column % side];
        if (q.x >= 0 && toroidal_distance_squared(p, q) < radius * radius) return false;
      }
    }
    return true;
  };
  std::vector<Point2> points;
  for (int left = sweeps; left > 0; --left) {
    for (std::size_t k = open.size(); k > 1; --k) std::swap(open[k - 1], open[rng() % k]);
    std::vector<std::uint32_t> still_open;
    for (const std::uint32_t cell : open) {
      const int i = static_cast<int>(cell) % side, j = static_cast<int>(cell) / side;
      const Point2 p{std::min((i + uniform(rng)) / side, below_one),
                     std::min((j + uniform(rng)) / side, below_one)};
      if (fits(p, i, j)) {
        in_cell[cell] = p;
        points.push_back(p);
      } else {
        still_open.push_back(cell);
      }
    }
    open = still_open;
  }
  return columns_of(points);
}

}  // namespace mc
