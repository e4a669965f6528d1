#pragma once

#include <algorithm>
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

/// Errors of independent replicates: sums of their powers. Of no errors, everything is NaN.
struct ErrorSums {
  double count = 0, sum = 0, squares = 0, fourths = 0, sixths = 0, eighths = 0;
  double points = 0;  ///< in all sets
  void add(double error, double of_points = 0) {
    const double square = error * error;
    ++count;
    points += of_points;
    sum += error;
    squares += square;
    fourths += square * square;
    sixths += square * square * square;
    eighths += square * square * square * square;
  }
  double mean() const { return sum / count; }
  double mean_error() const {
    return std::sqrt(std::max(0.0, squares / count - mean() * mean()) / count);
  }
  double rmse() const { return std::sqrt(squares / count); }
  /// Of the RMSE: that of the mean square, by the delta method.
  double standard_error() const {
    const double mean = squares / count;
    return std::sqrt(std::max(0.0, fourths / count - mean * mean) / count) / (2 * rmse());
  }
  /// About the exact value: 3 where the errors are normal.
  double kurtosis() const { return fourths * count / (squares * squares); }
  /// Of the kurtosis k = m4 / m2^2, by the delta method: an error x moves it by
  /// x^4 / m2^2 - 2 k x^2 / m2 + k. (Where the errors are normal this is sqrt(24 / count).) Where
  /// a few huge errors make k, there are too few of them in most samples, and this is too small.
  double kurtosis_error() const {
    const double m2 = squares / count, k = kurtosis();
    const double variance = eighths / count / std::pow(m2, 4) -
                            4 * k * sixths / count / std::pow(m2, 3) + 4 * k * k * k - k * k;
    return std::sqrt(std::max(0.0, variance) / count);
  }
};

}  // namespace mc::measurements
