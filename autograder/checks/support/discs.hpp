#pragma once
// Discs on the torus: how much of the unit square they cover, and how close their centers are.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace mc::checks {

/// The area of the unit square that no disc of `radius` around a point (x[i], y[i]) covers: on the
/// torus, or where discs end at the edges of the square. Exact along `rows` lines of constant y,
/// the first at `start` rows; the midpoint rule across them. So the error is that of a
/// one-dimensional sum: below 1e-4 with 1000 rows, and a few per cent of the area where that is one
/// gap 20 rows high. On the torus the radius is below sqrt(1/2), or every point covers all. Faster
/// where x is in order.
inline double uncovered_area(std::span<const double> x, std::span<const double> y, double radius,
                             std::size_t rows, double start = 0.5, bool torus = true) {
  if (torus && radius >= std::sqrt(0.5)) return x.empty() ? 1 : 0;
  // Kept between calls: allocating thousands of small lists is expensive.
  static std::vector<std::vector<std::pair<double, double>>> covered;
  covered.resize(std::max(covered.size(), rows));
  for (std::size_t row = 0; row < rows; ++row) covered[row].clear();
  const auto count = static_cast<double>(rows);
  for (std::size_t i = 0; i < x.size(); ++i) {
    double first = std::ceil((y[i] - radius) * count - start);
    double last = std::floor((y[i] + radius) * count - start);
    if (!torus) first = std::max(first, 0.0), last = std::min(last, count - 1);
    for (double row = first; row <= last; ++row) {
      const double dy = (row + start) / count - y[i];
      const double half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      auto& line = covered[static_cast<std::size_t>(row + 2 * count) % rows];
      double low = x[i] - half, high = x[i] + half;  // on the torus shorter than two
      if (torus && high - low >= 1) low = 0, high = 1;
      if (!torus) low = std::max(low, 0.0), high = std::min(high, 1.0);
      if (low < 0) line.push_back({low + 1, 1}), low = 0;
      if (high > 1) line.push_back({0, high - 1}), high = 1;
      line.push_back({low, high});
    }
  }
  double area = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    auto& line = covered[row];
    std::sort(line.begin(), line.end(),
              [](const auto& one, const auto& other) { return one.first < other.first; });
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

/// The least distance of any two points of [0,1)^2 on the torus; infinite below two points. Takes
/// n log n, wherever they lie: a line sweeps over the square along x, and once more over its
/// beginning; a set holds the points that it has just passed, by y. No two of them are
/// closer than that, so a few lie within it of any y.
inline double least_distance(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  if (n < 2) return std::numeric_limits<double>::infinity();
  std::vector<std::size_t> by_x(n);
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::sort(by_x.begin(), by_x.end(), [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
  const auto place = [&](std::size_t step) {
    return x[by_x[step % n]] + static_cast<double>(step / n);
  };
  std::set<std::pair<double, std::size_t>> passed;
  double least = 1;  // no two are farther apart than sqrt(1/2)
  std::size_t last = 0;
  for (std::size_t step = 0; step < 2 * n && place(step) <= 1 + least; ++step) {
    const std::size_t p = by_x[step % n];
    for (; place(step) - place(last) > least; ++last)
      passed.erase({y[by_x[last % n]], by_x[last % n]});
    for (const double turn : {-1.0, 0.0, 1.0}) {
      auto near = passed.lower_bound({y[p] + turn - least, 0});
      for (; near != passed.end() && near->first <= y[p] + turn + least; ++near) {
        const std::size_t q = near->second;
        if (q == p) continue;
        const double dx = short_way(x[p] - x[q]), dy = short_way(y[p] - y[q]);
        least = std::min(least, std::sqrt(dx * dx + dy * dy));
        if (least == 0) return 0;
      }
    }
    passed.insert({y[p], p});
  }
  return least;
}

}  // namespace mc::checks
