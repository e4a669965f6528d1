#pragma once
// What lab 5's plots integrate.

#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

namespace mc::checks {

struct Integral {
  std::size_t dims;
  double (*g)(std::span<const double>);
  double exact;
};

namespace integrands {
inline double smooth(std::span<const double> x) {
  return std::exp(std::accumulate(x.begin(), x.end(), 0.0));
}
inline double kink(std::span<const double> x) {
  return std::abs(x[0] - 0.4) + std::abs(x[0] + x[1] - 1);
}
inline double edge(std::span<const double> x) {
  return x[0] * x[0] + x[1] * x[1] < 0.7 ? 1 : 0;
}
}  // namespace integrands

inline const double e_1 = std::expm1(1.0);
inline const std::array<Integral, 5> plot_integrals{
    Integral{1, integrands::smooth, e_1}, Integral{2, integrands::smooth, std::pow(e_1, 2)},
    Integral{4, integrands::smooth, std::pow(e_1, 4)},
    Integral{2, integrands::kink, 0.26 + 1. / 3},      // (.4^2 + .6^2)/2, and E|x + y - 1|
    Integral{2, integrands::edge, 0.7 * std::atan(1)}  // a quarter of a disk of radius sqrt(.7) < 1
};

/// Over points in as many dimensions, or more: the values less the exact integral, and their
/// squares.
struct Sums {
  double errors = 0, squares = 0;
};
inline Sums sums_over(const std::vector<std::vector<double>>& points, const Integral& integral) {
  Sums sums;
  std::array<double, 4> x{};
  for (std::size_t i = 0; i < points[0].size(); ++i) {
    for (std::size_t d = 0; d < integral.dims; ++d) x[d] = points[d][i];
    const double error = integral.g({x.data(), integral.dims}) - integral.exact;
    sums.errors += error;
    sums.squares += error * error;
  }
  return sums;
}

}  // namespace mc::checks
