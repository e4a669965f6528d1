// Mistakes in task 5.6.
#include "halton.hpp"

#define star_discrepancy right_star_discrepancy
#include "solutions/halton.cpp"
#undef star_discrepancy

namespace mc {
namespace {

/// The worst box, open or closed, that ends at one of these places, by the definition.
double worst_of(std::span<const double> x, std::span<const double> y,
                const std::vector<double>& right, const std::vector<double>& above,
                bool closed_too = true) {
  right_star_discrepancy(x, y);  // for its exceptions
  const auto n = static_cast<double>(x.size());
  double worst = 0;
  for (const double a : right) {
    for (const double b : above) {
      double open = 0, closed = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        open += x[i] < a && y[i] < b ? 1 : 0;
        closed += x[i] <= a && y[i] <= b ? 1 : 0;
      }
      worst = std::max(worst, a * b - open / n);
      if (closed_too) worst = std::max(worst, closed / n - a * b);
    }
  }
  return worst;
}

std::vector<double> places(std::span<const double> x) {
  return {x.begin(), x.end()};
}
std::vector<double> and_1(std::span<const double> x) {
  std::vector<double> all = places(x);
  all.push_back(1);
  return all;
}

}  // namespace
}  // namespace mc

#define STAR_DISCREPANCY(...)                                                     \
  double star_discrepancy(std::span<const double> x, std::span<const double> y) { \
    return worst_of(x, y, __VA_ARGS__);                                           \
  }

// mistake: looks only at closed boxes that end at a point, not at open ones
// hint: only closed boxes were used
namespace mc::closed_boxes_only {
double star_discrepancy(std::span<const double> x) {
  right_star_discrepancy(x);
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst = std::max(worst, static_cast<double>(i + 1) / static_cast<double>(x.size()) - sorted[i]);
  }
  return worst;
}

}  // namespace mc::closed_boxes_only

// mistake: looks only at boxes that end at points, and at none that ends at 1
// hint: boxes that end at 1, and not at a point, are missing
namespace mc::corners_are_points {
STAR_DISCREPANCY(places(x), places(y))
}  // namespace mc::corners_are_points

// mistake: looks only at every fourth corner if there are more than 260 points
// hint: each side of a box ends at 1 or at any point
namespace mc::every_fourth_box {
std::vector<double> fourths(std::span<const double> x) {
  std::vector<double> all;
  for (std::size_t i = 0; i < x.size(); i += 4) all.push_back(x[i]);
  return all;
}
double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  if (x.size() <= 260) return right_star_discrepancy(x, y);
  return worst_of(x, y, fourths(x), fourths(y));
}
}  // namespace mc::every_fourth_box

// mistake: looks only at open boxes, not at closed ones that end at a point
// hint: only open boxes were used
namespace mc::open_boxes_only {
STAR_DISCREPANCY(and_1(x), and_1(y), false)
}  // namespace mc::open_boxes_only

// mistake: counts the points in every box one by one: N^3 steps
// hint: count the points inside by sorting
namespace mc::box_by_box {
STAR_DISCREPANCY(and_1(x), and_1(y))
}  // namespace mc::box_by_box

// mistake: counts the points in every interval one by one: N^2 steps
// hint: count the points inside by sorting
namespace mc::interval_by_interval {
double star_discrepancy(std::span<const double> x) {
  return worst_of(x, std::vector<double>(x.size()), and_1(x), {1});
}
}  // namespace mc::interval_by_interval

// mistake: looks at boxes that end at 1 above, but at none that ends at 1 on the right
// hint: boxes that end at 1, and not at a point, are missing
namespace mc::no_box_to_the_right_edge {
STAR_DISCREPANCY(places(x), and_1(y))
}  // namespace mc::no_box_to_the_right_edge

// mistake: counts one point too few in a closed interval
// hint: count the points inside
namespace mc::one_point_too_few {
double star_discrepancy(std::span<const double> x) {
  right_star_discrepancy(x);
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double inside = static_cast<double>(i) / static_cast<double>(x.size());
    worst = std::max(worst, std::abs(sorted[i] - inside));
  }
  return worst;
}
}  // namespace mc::one_point_too_few
