// alternative: the discrepancy strip by strip, on the line by Niederreiter's formula; shifts
// wrapped by floor
#include "halton.hpp"

#include <algorithm>
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
  std::vector<double> rights(x.begin(), x.end());
  rights.push_back(1);
  double worst = 0;
  for (const double right : rights) {
    std::vector<double> open, closed;  // y of the points in a strip
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (x[i] < right) open.push_back(y[i]);
      if (x[i] <= right) closed.push_back(y[i]);
    }
    std::sort(open.begin(), open.end());
    std::sort(closed.begin(), closed.end());
    for (std::size_t k = 0; k <= open.size(); ++k) {
      const double top = k < open.size() ? open[k] : 1;
      worst = std::max(worst, right * top - static_cast<double>(k) / n);
    }
    for (std::size_t k = 0; k < closed.size(); ++k) {
      worst = std::max(worst, static_cast<double>(k + 1) / n - right * closed[k]);
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
