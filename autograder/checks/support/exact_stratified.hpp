#pragma once
// Exact variances of stratified estimates for finite N, from the means and variances of a function
// within the strata. Nothing is asymptotic: the error of a correct answer is known for every N.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "checks/support/exact.hpp"
#include "checks/support/quadrature.hpp"

namespace mc::checks {

/// The mean and variance of a function within each of N strata of equal volume.
struct WithinStrata {
  std::vector<double> mean, variance;
  std::size_t size() const { return mean.size(); }
};

inline double sum_of_squares_of(const std::vector<double>& x) {
  return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

inline double mean_of(const WithinStrata& strata) {
  return sum_of(strata.mean) / static_cast<double>(strata.size());
}

inline double between(const WithinStrata& strata) {
  return squared_deviations(strata.mean);
}

/// A smooth function h over n equal strata of [0,1).
template <class Function>
WithinStrata strata_of(Function h, std::size_t n) {
  WithinStrata strata;
  const auto size = static_cast<double>(n);
  for (double i = 0; i < size; ++i) {
    const auto average = [&](auto f) { return size * integral(i / size, (i + 1) / size, 1, f); };
    const double mean = average(h);
    strata.mean.push_back(mean);
    strata.variance.push_back(average([&](double x) { return (h(x) - mean) * (h(x) - mean); }));
  }
  return strata;
}

/// f(x) g(y) over the grid of f's and g's strata.
inline WithinStrata product_of(const WithinStrata& f, const WithinStrata& g) {
  WithinStrata cells;
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) {
      const double f_squared = f.mean[i] * f.mean[i], g_squared = g.mean[j] * g.mean[j];
      cells.mean.push_back(f.mean[i] * g.mean[j]);
      cells.variance.push_back(f.variance[i] * g.variance[j] + f.variance[i] * g_squared +
                               g.variance[j] * f_squared);
    }
  }
  return cells;
}

/// The area of [0,side)^2 where cx + sy < t, for c, s > 0: a triangle, minus corners outside.
inline double area_below(double c, double s, double t, double side) {
  const auto triangle = [](double rest) { return rest > 0 ? rest * rest : 0.0; };
  return (triangle(t) - triangle(t - c * side) - triangle(t - s * side) +
          triangle(t - (c + s) * side)) /
         (2 * c * s);
}

/// An edge across side x side cells: 1 where cos(1)(x - 1/2) + sin(1)(y - 1/2) < edge, else 0. A
/// cell of which it covers a fraction p has variance p (1 - p).
inline WithinStrata edge_strata(double edge, std::size_t side) {
  const double c = std::cos(1.0), s = std::sin(1.0), width = 1 / static_cast<double>(side);
  WithinStrata cells;
  for (std::size_t j = 0; j < side; ++j) {
    for (std::size_t i = 0; i < side; ++i) {
      const double t = edge - c * (static_cast<double>(i) * width - 0.5) -
                       s * (static_cast<double>(j) * width - 0.5);
      const double p = area_below(c, s, t, width) / (width * width);
      cells.mean.push_back(p);
      cells.variance.push_back(std::max(0.0, p * (1 - p)));
    }
  }
  return cells;
}

/// Variance of the mean of one point in each stratum (Cochran, "Sampling techniques", theorem 5.3).
inline double stratified_variance(const WithinStrata& strata) {
  const auto n = static_cast<double>(strata.size());
  return sum_of(strata.variance) / (n * n);
}

/// Kurtosis of that mean for an edge, whose cells are Bernoulli: fourth cumulants add up.
inline double edge_kurtosis(const WithinStrata& strata) {
  double fourth = 0;
  for (const double variance : strata.variance) fourth += variance * (1 - 6 * variance);
  return 3 + fourth / (sum_of(strata.variance) * sum_of(strata.variance));
}

inline double independent_variance(const WithinStrata& strata, std::size_t n) {
  return (sum_of(strata.variance) + between(strata)) / static_cast<double>(strata.size()) /
         static_cast<double>(n);
}

/// Variance of the mean of the first `used` points of one point per stratum in random order: strata
/// drawn without replacement (Cochran, theorem 2.2), and the variance within each of them.
inline double variance_of_first(const WithinStrata& strata, std::size_t used) {
  const auto size = static_cast<double>(strata.size()), n = static_cast<double>(used);
  const double within = sum_of(strata.variance) / size, around = between(strata) / size;
  return (within + around * (size - n) / (size - 1)) / n;
}

/// Variance of the mean of f(p) g(q) over N points, p stratified by f's N strata and q by g's, in
/// independent orders (two columns of a Latin hypercube, two padded patterns). The sum of f.mean[i]
/// g.mean[pi(i)] over a random permutation pi has the variance between(f) between(g) / (N - 1)
/// (Hoeffding 1951, "A combinatorial central limit theorem", theorem 2).
inline double shuffled_product_variance(const WithinStrata& f, const WithinStrata& g) {
  const auto n = static_cast<double>(f.size());
  const double within_f = sum_of(f.variance), within_g = sum_of(g.variance);
  const double within = within_f * within_g + within_f * sum_of_squares_of(g.mean) +
                        within_g * sum_of_squares_of(f.mean);
  return (within / n + between(f) * between(g) / (n - 1)) / (n * n);
}

}  // namespace mc::checks
