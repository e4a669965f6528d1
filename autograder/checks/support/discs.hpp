#pragma once
// Discs on the torus: how much of the unit square they cover, and how close their centres are.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace mc::checks {

/// The area of the unit square, a torus, that no disc of `radius` around a point (x[i], y[i])
/// covers. Exact along `rows` lines of constant y, the first at `start` rows; the midpoint rule
/// across them. So the error is that of a one-dimensional sum: below 1e-4 with 1000 rows, and a few
/// per cent of the area where that is one gap 20 rows high.
inline double uncovered_area(std::span<const double> x, std::span<const double> y, double radius,
                             std::size_t rows, double start = 0.5) {
  if (radius >= std::sqrt(0.5)) return x.empty() ? 1 : 0;
  // Kept between calls: thousands of small lists are dear to make.
  static std::vector<std::vector<std::pair<double, double>>> covered;
  covered.resize(std::max(covered.size(), rows));
  for (std::size_t row = 0; row < rows; ++row) covered[row].clear();
  const auto count = static_cast<double>(rows);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double first = std::ceil((y[i] - radius) * count - start);
    const double last = std::floor((y[i] + radius) * count - start);
    for (double row = first; row <= last; ++row) {
      const double dy = (row + start) / count - y[i];
      const double half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      auto& line = covered[static_cast<std::size_t>(row + 2 * count) % rows];
      double low = x[i] - half, high = x[i] + half;  // shorter than two: radius < sqrt(1/2)
      if (high - low >= 1) low = 0, high = 1;
      if (low < 0) line.push_back({low + 1, 1}), low = 0;
      if (high > 1) line.push_back({0, high - 1}), high = 1;
      line.push_back({low, high});
    }
  }
  double area = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    auto& line = covered[row];
    std::sort(line.begin(), line.end());
    double at = 0;
    for (const auto& [low, high] : line) {
      if (low > at) area += (low - at) / count;
      at = std::max(at, high);
    }
    area += (1 - at) / count;
  }
  return area;
}

/// The length of a difference of coordinates, round the torus if that is shorter.
inline double short_way(double difference) {
  const double inside = std::abs(difference);
  return std::min(inside, 1 - inside);
}

/// The distance on the torus of the point `p` to the nearest of the first `among` of the points.
inline double nearest_distance(std::span<const double> x, std::span<const double> y, std::size_t p,
                               std::size_t among) {
  double least = std::numeric_limits<double>::infinity();  // squared
  for (std::size_t i = 0; i < among; ++i) {
    if (i == p) continue;
    const double dx = short_way(x[i] - x[p]), dy = short_way(y[i] - y[p]);
    least = std::min(least, dx * dx + dy * dy);
  }
  return std::sqrt(least);
}

/// The least distance of any two points on the torus; infinite below two points.
inline double least_distance(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  double least = std::numeric_limits<double>::infinity();  // squared
  if (n < 2) return least;
  // By x: only those within the least distance so far need be looked at, round the seam too.
  std::vector<std::pair<double, double>> points(n);
  for (std::size_t i = 0; i < n; ++i) points[i] = {x[i], y[i]};
  std::sort(points.begin(), points.end());
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t step = 1; step < n; ++step) {
      const std::size_t k = (i + step) % n;
      const double dx = points[k].first - points[i].first + (k < i ? 1 : 0);
      if (dx * dx > least || dx > 0.5) break;
      const double dy = short_way(points[k].second - points[i].second);
      least = std::min(least, dx * dx + dy * dy);
    }
  }
  return std::sqrt(least);
}

}  // namespace mc::checks
