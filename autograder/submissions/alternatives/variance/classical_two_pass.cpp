// alternative: eq. 1.7 exactly as in the paper, about the mean as it was rounded; 1.8 is 1.3
// again, without lanes or blocks; the textbook formula by its sums

#include "variance.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double mean(std::span<const double> x) {
  if (x.empty()) return nan;
  double sum = 0;
  for (double value : x) sum += value;
  if (std::isfinite(sum)) return sum / static_cast<double>(x.size());
  sum = 0;
  for (double value : x) sum += value * 0x1p-60;  // room for 2^60 values
  return sum / static_cast<double>(x.size()) * 0x1p60;
}

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  double squares = 0;
  for (double value : x) {
    sum += value;
    squares += value * value;
  }
  return (squares - sum * sum / n) / (n - 1);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto n = static_cast<double>(x.size());
  const double center = mean(x);
  double m2 = 0;
  double off = 0;
  for (double value : x) {
    m2 += (value - center) * (value - center);
    off += value - center;
  }
  m2 -= off * off / n;
  return {x.size(), center + off / n, m2 < 0 ? 0 : m2};
}

double variance_two_pass(std::span<const double> x) {
  return variance(moments(x));
}

void add(Moments& moments, double x) {
  const double delta = x - moments.mean;
  const auto n = static_cast<double>(++moments.count);
  moments.mean += delta / n;
  moments.m2 += delta * delta * ((n - 1) / n);
}

double variance(const Moments& moments) {
  return moments.count < 2 ? nan : moments.m2 / (static_cast<double>(moments.count) - 1);
}

Moments merge(const Moments& a, const Moments& b) {
  if (a.count + b.count == 0) return {};
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  const double delta = a.mean - b.mean;
  return {a.count + b.count, n_a / (n_a + n_b) * a.mean + n_b / (n_a + n_b) * b.mean,
          a.m2 + b.m2 + delta * n_a * n_b / (n_a + n_b) * delta};
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("y has not the size of x");
  if (x.size() < 2) return nan;
  const double mean_x = mean(x), mean_y = mean(y);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - mean_x) * (y[i] - mean_y);
  return sum / static_cast<double>(x.size() - 1);
}

double dependence(std::span<const double> joint, std::size_t columns) {
  if (columns == 0) throw std::invalid_argument("columns is 0");
  if (joint.size() % columns != 0) throw std::invalid_argument("columns does not divide joint");
  const std::size_t rows = joint.size() / columns;
  std::vector<double> of_row(rows), of_column(columns);
  double total = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double weight = joint[row * columns + column];
      if (weight < 0 || !std::isfinite(weight)) throw std::invalid_argument("joint: a bad weight");
      total += weight;
      of_row[row] += weight;
      of_column[column] += weight;
    }
  }
  if (total <= 0) throw std::invalid_argument("joint: total of 0");
  double most = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const double product = of_row[row] / total * (of_column[column] / total);
      most = std::fmax(most, std::fabs(joint[row * columns + column] / total - product));
    }
  }
  return most;
}

}  // namespace mc
