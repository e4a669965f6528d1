// mistake: looks at boxes that end just before a point, and not just behind it
// caught by: 5.6 the star discrepancy of points of the plane
// caught by: 5.6 points that share
// caught by: 5.6 no error
// hint: only open boxes were looked at
#include "halton.hpp"

#define star_discrepancy right_star_discrepancy
#include "solutions/halton.cpp"
#undef star_discrepancy

namespace mc {

double star_discrepancy(std::span<const double> x) {
  return right_star_discrepancy(x);
}

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

}  // namespace mc
