// mistake: looks at boxes that end at points, and at none that ends at 1
// caught by: 5.6 the star discrepancy of points of the plane
// caught by: 5.6 points that share
// caught by: 5.6 no error exceeds
// hint: those that end at 1 count too
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

}  // namespace mc
