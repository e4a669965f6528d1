#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace mc {

/// The quantile function (inverse CDF) of the standard normal distribution at `p`: 1.96 for 0.975.
/// Within 1e-14 |x| + 1e-16 of the exact x for every p, including subnormal ones; -inf at 0, inf at
/// 1, NaN outside [0,1].
///
/// An initial guess is accurate to 4.5e-4. Two steps of Halley's method follow, each of which
/// triples the number of correct digits: 3, 10, all.
/// source: Abramowitz, Stegun 1964, "Handbook of mathematical functions", 26.2.23.
inline double normal_quantile(double p) {
  if (!(p >= 0 && p <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (p > 0.5) return -normal_quantile(1 - p);
  if (p == 0) return -std::numeric_limits<double>::infinity();
  const double t = std::sqrt(-2 * std::log(p));
  double x = (2.515517 + t * (0.802853 + t * 0.010328)) /
                 (1 + t * (1.432788 + t * (0.189269 + t * 0.001308))) -
             t;
  for (int step = 0; step < 2; ++step) {
    if (p < 1e-300) {
      // Here erfc may underflow and exp overflow, so this is Newton's method for the logarithm of
      // the probability. Successive terms of its asymptotic series (26.2.12) shrink by a factor of
      // 1e-3.
      const double v = 1 / (x * x);
      const double series = 1 - v * (1 - 3 * v * (1 - 5 * v * (1 - 7 * v * (1 - 9 * v))));
      const double log_p = -x * x / 2 + std::log(series / (-x * std::sqrt(2 * std::numbers::pi)));
      x -= (log_p - std::log(p)) * series / -x;
      continue;
    }
    const double excess = std::erfc(-x / std::numbers::sqrt2) / 2 - p;
    const double newton = excess * std::sqrt(2 * std::numbers::pi) * std::exp(x * x / 2);
    x -= newton / (1 + x * newton / 2);
  }
  return x;
}

}  // namespace mc
