// alternative: the discrepancy box by box, on the line by Niederreiter's formula; shifts wrapped by
// floor
#include "halton.hpp"

#include <cmath>

#define star_discrepancy right_star_discrepancy
#define random_shift right_random_shift
#include "solutions/halton.cpp"
#undef star_discrepancy
#undef random_shift

namespace mc {

double star_discrepancy(std::span<const double> x) {
  require_points(x, "x");
  std::vector<double> sorted(x.begin(), x.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(x.size());
  double worst = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    worst = std::max(worst, std::abs(sorted[i] - (static_cast<double>(i) + 0.5) / n));
  }
  return 0.5 / n + worst;
}

double star_discrepancy(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x, y: not as many");
  require_points(x, "x");
  require_points(y, "y");
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

void random_shift(PointSet& points, Rng& rng) {
  std::vector<double> shifts(points.dims());
  for (double& shift : shifts) shift = static_cast<double>(rng() >> 11) * 0x1p-53;
  for (std::size_t d = points.dims(); d-- > 0;) {
    for (double& value : points.column(d)) {
      value += shifts[d];
      value -= std::floor(value);
    }
  }
}

}  // namespace mc
