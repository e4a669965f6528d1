#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mc::measurements {

/// The middle one of an odd number of values.
inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Errors of independent replicates. Of no errors, everything is NaN.
struct ErrorSums {
  std::array<double, 9> powers{};  ///< [k]: the sum of the k-th powers of the errors
  double points = 0;               ///< in all sets
  void add(double error, double of_points = 0) {
    points += of_points;
    double power = 1;
    for (double& sum : powers) {
      sum += power;
      power *= error;
    }
  }
  double count() const { return powers[0]; }
  /// The mean of their k-th powers, and its standard error, for k up to 4.
  double moment(std::size_t k) const { return powers[k] / count(); }
  double moment_error(std::size_t k) const {
    return std::sqrt(std::max(0.0, moment(2 * k) - moment(k) * moment(k)) / count());
  }
  double rmse() const { return std::sqrt(moment(2)); }
  /// Of the RMSE, by the delta method.
  double standard_error() const { return moment_error(2) / (2 * rmse()); }
  /// About the exact value: 3 where the errors are normal.
  double kurtosis() const { return moment(4) / std::pow(moment(2), 2); }
  /// Of the kurtosis k = m4 / m2^2, by the delta method: an error x moves it by
  /// x^4 / m2^2 - 2 k x^2 / m2 + k. (Where the errors are normal this is sqrt(24 / count).) Where
  /// a few huge errors make k, there are too few of them in most samples, and this is too small.
  double kurtosis_error() const {
    const double m2 = moment(2), k = kurtosis();
    const double variance =
        moment(8) / std::pow(m2, 4) - 4 * k * moment(6) / std::pow(m2, 3) + 4 * k * k * k - k * k;
    return std::sqrt(std::max(0.0, variance) / count());
  }
};

}  // namespace mc::measurements
