#pragma once
// The star discrepancy by its definition, to judge by: box by box, also of some boxes only, as a
// mistake has it; and of hundreds of points faster.

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace mc::checks {

/// Which boxes are looked at.
struct Boxes {
  bool open = true, closed = true;
  bool to_1 = true;  ///< also those that end at 1, not at a point
};

/// Every box that ends on coordinates of points or on 1, open and closed.
inline double exact_discrepancy(std::span<const double> x, std::span<const double> y,
                                Boxes boxes = {}) {
  const auto n = static_cast<double>(x.size());
  std::vector<double> xs(x.begin(), x.end()), ys(y.begin(), y.end());
  if (boxes.to_1) xs.push_back(1), ys.push_back(1);
  double worst = 0;
  for (const double a : xs) {
    for (const double b : ys) {
      double inside = 0, at_most = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        inside += x[i] < a && y[i] < b ? 1 : 0;
        at_most += x[i] <= a && y[i] <= b ? 1 : 0;
      }
      if (boxes.open) worst = std::max(worst, a * b - inside / n);
      if (boxes.closed) worst = std::max(worst, at_most / n - a * b);
    }
  }
  return worst;
}

/// The same on the line.
inline double exact_discrepancy(std::span<const double> x, Boxes boxes = {}) {
  const auto n = static_cast<double>(x.size());
  std::vector<double> ends(x.begin(), x.end());
  if (boxes.to_1) ends.push_back(1);
  double worst = 0;
  for (const double a : ends) {
    const auto below = std::count_if(x.begin(), x.end(), [=](double value) { return value < a; });
    const auto equal = std::count(x.begin(), x.end(), a);
    if (boxes.open) worst = std::max(worst, a - static_cast<double>(below) / n);
    if (boxes.closed) worst = std::max(worst, static_cast<double>(below + equal) / n - a);
  }
  return worst;
}

/// Of all boxes, faster: for each height, the points below it from left to right.
inline double worst_box(std::span<const double> x, std::span<const double> y) {
  const auto n = static_cast<double>(x.size());
  std::vector<std::size_t> order(x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return x[i] < x[j]; });
  std::vector<double> heights(y.begin(), y.end());
  heights.push_back(1);
  double worst = 0;
  for (const double b : heights) {
    double inside = 0, at_most = 0;  // of those before the i-th, or equal to it, from the left
    for (std::size_t i = 0; i < order.size();) {
      const double a = x[order[i]];
      worst = std::max(worst, a * b - inside / n);
      for (; i < order.size() && x[order[i]] == a; ++i) {
        inside += y[order[i]] < b ? 1 : 0;
        at_most += y[order[i]] <= b ? 1 : 0;
      }
      worst = std::max(worst, at_most / n - a * b);
    }
    worst = std::max({worst, b - inside / n, at_most / n - b});
  }
  return worst;
}

}  // namespace mc::checks
