// Mistakes in task 5.6.
#include "halton.hpp"

#define star_discrepancy right_star_discrepancy
#include "solutions/halton.cpp"
#undef star_discrepancy

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
// hint: boxes that end at 1 count, too
namespace mc::corners_are_points {
double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  right_star_discrepancy(x, y);
  const auto n = static_cast<double>(x.size());
  double worst = 0;
  for (const double right : x) {
    for (const double top : y) {
      double open = 0, closed = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        open += x[i] < right && y[i] < top ? 1 : 0;
        closed += x[i] <= right && y[i] <= top ? 1 : 0;
      }
      worst = std::max({worst, right * top - open / n, closed / n - right * top});
    }
  }
  return worst;
}
}  // namespace mc::corners_are_points

// mistake: looks only at every fourth corner if there are more than 260 points
// hint: each side of a box ends at 1 or at any point
namespace mc::every_fourth_box {
double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  if (x.size() <= 260) return right_star_discrepancy(x, y);
  double worst = 0;
  for (std::size_t a = 0; a < x.size(); a += 4) {
    for (std::size_t b = 0; b < y.size(); b += 4) {
      double open = 0, closed = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        open += x[i] < x[a] && y[i] < y[b] ? 1 : 0;
        closed += x[i] <= x[a] && y[i] <= y[b] ? 1 : 0;
      }
      const auto n = static_cast<double>(x.size());
      worst = std::max({worst, x[a] * y[b] - open / n, closed / n - x[a] * y[b]});
    }
  }
  return worst;
}
}  // namespace mc::every_fourth_box

// mistake: looks only at open boxes, not at closed ones that end at a point
// hint: only open boxes were used
namespace mc::open_boxes_only {
double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  right_star_discrepancy(x, y);
  double worst = 0;
  for (std::size_t a = 0; a <= x.size(); ++a) {
    for (std::size_t b = 0; b <= y.size(); ++b) {
      const double right = a < x.size() ? x[a] : 1, top = b < y.size() ? y[b] : 1;
      double inside = 0;
      for (std::size_t i = 0; i < x.size(); ++i) inside += x[i] < right && y[i] < top ? 1 : 0;
      worst = std::max(worst, right * top - inside / static_cast<double>(x.size()));
    }
  }
  return worst;
}
}  // namespace mc::open_boxes_only

// mistake: counts the points in every box one by one: N^3 steps
// hint: count the points inside by sorting
namespace mc::box_by_box {
double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  right_star_discrepancy(x, y);
  const auto n = static_cast<double>(x.size());
  double worst = 0;
  for (std::size_t a = 0; a <= x.size(); ++a) {
    for (std::size_t b = 0; b <= y.size(); ++b) {
      const double right = a < x.size() ? x[a] : 1, top = b < y.size() ? y[b] : 1;
      double open = 0, closed = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        open += x[i] < right && y[i] < top ? 1 : 0;
        closed += x[i] <= right && y[i] <= top ? 1 : 0;
      }
      worst = std::max({worst, right * top - open / n, closed / n - right * top});
    }
  }
  return worst;
}
}  // namespace mc::box_by_box

// mistake: counts the points in every interval one by one: N^2 steps
// hint: count the points inside by sorting
namespace mc::interval_by_interval {
double star_discrepancy(std::span<const double> x) {
  right_star_discrepancy(x);
  const auto n = static_cast<double>(x.size());
  double worst = 0;
  for (const double end : x) {
    double open = 0, closed = 0;
    for (const double value : x) {
      open += value < end ? 1 : 0;
      closed += value <= end ? 1 : 0;
    }
    worst = std::max({worst, end - open / n, closed / n - end});
  }
  return worst;
}
}  // namespace mc::interval_by_interval

// mistake: looks at boxes that end at 1 above, but at none that ends at 1 on the right
// hint: boxes that end at 1 count, too
namespace mc::no_box_to_the_right_edge {
double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  right_star_discrepancy(x, y);
  const auto n = static_cast<double>(x.size());
  std::vector<double> tops(y.begin(), y.end());
  tops.push_back(1);
  double worst = 0;
  for (const double right : x) {
    for (const double top : tops) {
      double open = 0, closed = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        open += x[i] < right && y[i] < top ? 1 : 0;
        closed += x[i] <= right && y[i] <= top ? 1 : 0;
      }
      worst = std::max({worst, right * top - open / n, closed / n - right * top});
    }
  }
  return worst;
}
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
