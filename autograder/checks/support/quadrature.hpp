#pragma once
// Integrals of smooth functions.

#include <array>
#include <cmath>
#include <cstddef>

namespace mc::checks {

/// The integral of f from `low` to `high` by the 16-point Gauss-Legendre rule (Abramowitz, Stegun,
/// table 25.4) in panels no wider than `panel`. If f's nearest pole is one panel width away, the
/// relative error is about (2 + sqrt(5))^-32 = 1e-20.
template <class F>
double integral(double low, double high, double panel, F f) {
  constexpr std::array<double, 8> node{
      0.989400934991649933, 0.944575023073232576, 0.865631202387831744, 0.755404408355003034,
      0.617876244402643748, 0.458016777657227386, 0.281603550779258913, 0.095012509837637440};
  constexpr std::array<double, 8> weight{
      0.027152459411754095, 0.062253523938647893, 0.095158511682492785, 0.124628971255533872,
      0.149595988816576732, 0.169156519395002538, 0.182603415044923589, 0.189450610455068496};
  if (!(low < high)) return 0;
  const double panels = std::ceil((high - low) / panel), half = (high - low) / panels / 2;
  double sum = 0;
  for (double i = 0; i < panels; ++i) {
    const double middle = low + half * (2 * i + 1);
    for (std::size_t k = 0; k < node.size(); ++k) {
      sum += weight[k] * (f(middle - half * node[k]) + f(middle + half * node[k]));
    }
  }
  return half * sum;
}

}  // namespace mc::checks
