// mistake: of more than 260 points, looks at every fourth place for a corner only
// caught by: 5.6 no error exceeds
// hint: some box was not looked at
#include "halton.hpp"

#define star_discrepancy right_star_discrepancy
#include "solutions/halton.cpp"
#undef star_discrepancy

namespace mc {

double star_discrepancy(std::span<const double> x) {
  return right_star_discrepancy(x);
}

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

}  // namespace mc
