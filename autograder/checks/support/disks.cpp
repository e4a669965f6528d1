#include "checks/support/disks.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace mc::checks {

double uncovered_area(std::span<const double> x, std::span<const double> y, double radius,
                      std::size_t rows, double start, bool torus) {
  if (torus && radius >= std::sqrt(0.5)) return x.empty() ? 1 : 0;
  // Reused by later calls: allocating thousands of small lists is slow.
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
      double low = x[i] - half, high = x[i] + half;  // on the torus, shorter than 2
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
    std::ranges::sort(line,
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

double least_distance(std::span<const double> x, std::span<const double> y) {
  const std::size_t n = x.size();
  if (n < 2) return std::numeric_limits<double>::infinity();
  std::vector<std::size_t> by_x(n);
  std::iota(by_x.begin(), by_x.end(), std::size_t{0});
  std::ranges::sort(by_x, [&](std::size_t a, std::size_t b) { return x[a] < x[b]; });
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
