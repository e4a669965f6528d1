#pragma once
// Moments of lists of doubles: in double, and exactly, in double-double arithmetic (106 bits).

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace mc::checks {

/// An unevaluated sum of two doubles, |low| <= ulp(high)/2. Sums and products after Dekker 1971 and
/// Hida, Li, Bailey 2001 ("Library for double-double and quad-double arithmetic", algorithms 3-7);
/// relative error below 2^-104. The caller must avoid overflow and NaN.
struct Exact {
  double high = 0;
  double low = 0;

  Exact() = default;
  Exact(double value) : high(value) {}
  explicit operator double() const { return high + low; }
};

inline Exact quick_two_sum(double a, double b) {  // |a| >= |b|
  Exact sum(a + b);
  sum.low = b - (sum.high - a);
  return sum;
}
inline Exact two_sum(double a, double b) {
  Exact sum(a + b);
  const double part = sum.high - a;
  sum.low = (a - (sum.high - part)) + (b - part);
  return sum;
}
inline Exact two_product(double a, double b) {
  Exact product(a * b);
  product.low = std::fma(a, b, -product.high);
  return product;
}

inline Exact operator-(Exact a) {
  a.high = -a.high;
  a.low = -a.low;
  return a;
}
inline Exact operator+(Exact a, Exact b) {
  Exact high = two_sum(a.high, b.high);
  const Exact low = two_sum(a.low, b.low);
  high = quick_two_sum(high.high, high.low + low.high);
  return quick_two_sum(high.high, high.low + low.low);
}
inline Exact operator-(Exact a, Exact b) {
  return a + -b;
}
inline Exact operator*(Exact a, Exact b) {
  const Exact product = two_product(a.high, b.high);
  return quick_two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
inline Exact operator/(Exact a, Exact b) {
  const double first = a.high / b.high;
  Exact rest = a - b * Exact(first);
  const double second = rest.high / b.high;
  rest = rest - b * Exact(second);
  return quick_two_sum(first, second) + Exact(rest.high / b.high);
}

inline double sum_of(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0.0);
}

/// The sum that std::accumulate(…, 0) returns: it adds in int.
inline double integer_sum(std::span<const double> x) {
  double sum = 0;
  for (const double value : x) sum = std::trunc(sum + value);
  return sum;
}

/// The sum of squared deviations from the mean, in double.
inline double squared_deviations(std::span<const double> x) {
  const double mean = sum_of(x) / static_cast<double>(x.size());
  double sum = 0;
  for (const double value : x) sum += (value - mean) * (value - mean);
  return sum;
}

/// Mean, sum of squared deviations and sample variance, in two passes; NaN where undefined.
struct ExactMoments {
  double count = 0;
  Exact mean, m2;
  double variance = std::numeric_limits<double>::quiet_NaN();
};

inline Exact exact_mean(std::span<const double> x) {
  Exact sum;
  for (const double value : x) sum = sum + value;
  return sum / static_cast<double>(x.size());
}

inline Exact exact_codeviation(std::span<const double> x, std::span<const double> y) {
  const Exact mean_x = exact_mean(x), mean_y = exact_mean(y);
  Exact sum;
  for (std::size_t i = 0; i < x.size(); ++i) sum = sum + (x[i] - mean_x) * (y[i] - mean_y);
  return sum;
}

/// The condition number of the variance, kappa = sqrt(1 + mean^2 / variance).
inline double condition(const ExactMoments& exact) {
  const double mean = static_cast<double>(exact.mean);
  return std::sqrt(1 + mean * mean / exact.variance);
}

inline ExactMoments exact_moments(std::span<const double> x) {
  ExactMoments moments;
  moments.count = static_cast<double>(x.size());
  if (x.empty()) return moments;
  moments.mean = exact_mean(x);
  moments.m2 = exact_codeviation(x, x);
  if (x.size() > 1) moments.variance = static_cast<double>(moments.m2 / (moments.count - 1));
  return moments;
}

}  // namespace mc::checks
