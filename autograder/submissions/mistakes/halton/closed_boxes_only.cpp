// mistake: looks at boxes that end just behind a point, and not just before it
// caught by: 5.6 the star discrepancy of points of the line
// caught by: 5.6 points that share
// hint: only closed boxes were looked at
#include "halton.hpp"

#define star_discrepancy right_star_discrepancy
#include "solutions/halton.cpp"
#undef star_discrepancy

namespace mc {

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

double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  return right_star_discrepancy(x, y);
}

}  // namespace mc
