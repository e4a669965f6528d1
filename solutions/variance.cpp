// Lab 1 · variance: the reference solution. Each function is its definition first; where a faster
// way stands below, its reason stands with it.

#include "variance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// 1.1 --------------------------------------------------------------------------------------------

double mean(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  for (double value : x) sum += value;
  if (std::isfinite(sum)) return sum / n;  // 0/0 is NaN: the mean of nothing

  // The sum overflowed; the mean need not have. Small shares of each value cannot.
  double shares = 0;
  for (double value : x) shares += value / n;
  return shares;
}

// 1.2 --------------------------------------------------------------------------------------------

double variance_textbook(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  if (n < 2) return nan;
  double sum = 0;
  double sum_of_squares = 0;
  for (double value : x) {
    sum += value;
    sum_of_squares += value * value;
  }
  const double mean = sum / n;
  return (sum_of_squares / n - mean * mean) * (n / (n - 1));  // two large numbers, nearly equal
}

// 1.3 --------------------------------------------------------------------------------------------

double variance_two_pass(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  if (n < 2) return nan;

  // The mean was rounded, once for every addition, so the deviations from it do not sum to zero.
  // What they do sum to tells by how much it is off.
  double centre = mean(x);
  double off = 0;
  for (double value : x) off += value - centre;
  centre += off / n;

  // Now it is off by one rounding at most. The correction takes back what that adds to m2.
  double m2 = 0;
  double correction = 0;
  for (double value : x) {
    const double deviation = value - centre;
    m2 += deviation * deviation;
    correction += deviation;
  }
  return std::max(0.0, m2 - correction * correction / n) / (n - 1);
}

// 1.4 --------------------------------------------------------------------------------------------

void add(Moments& moments, double x) {
  ++moments.count;
  const double before = x - moments.mean;
  moments.mean += before / static_cast<double>(moments.count);
  const double after = x - moments.mean;
  moments.m2 += before * after;  // one factor from each side of the update: both errors cancel
}

double variance(const Moments& moments) {
  if (moments.count < 2) return nan;
  return moments.m2 / static_cast<double>(moments.count - 1);
}

// 1.5 --------------------------------------------------------------------------------------------

Moments merge(const Moments& a, const Moments& b) {
  if (a.count == 0) return b;
  if (b.count == 0) return a;
  const auto n_a = static_cast<double>(a.count);
  const auto n_b = static_cast<double>(b.count);
  const double n = n_a + n_b;
  const double apart = b.mean - a.mean;
  return {a.count + b.count,
          // From the larger part's mean: a small step is a small rounding error.
          n_a >= n_b ? a.mean + apart * (n_b / n) : b.mean - apart * (n_a / n),
          a.m2 + b.m2 + apart * apart * (n_a / n * n_b)};
}

// 1.6 --------------------------------------------------------------------------------------------

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  const auto n = static_cast<double>(x.size());
  if (n < 2) return nan;
  const double mean_x = mean(x);
  const double mean_y = mean(y);
  double products = 0;
  double deviations_x = 0;
  double deviations_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    products += (x[i] - mean_x) * (y[i] - mean_y);
    deviations_x += x[i] - mean_x;
    deviations_y += y[i] - mean_y;
  }
  return (products - deviations_x * deviations_y / n) / (n - 1);  // corrected as 1.3 is
}

// 1.7 --------------------------------------------------------------------------------------------

double dependence(std::span<const double> joint, std::size_t columns) {
  if (columns == 0) throw std::invalid_argument("columns: there are none");
  if (joint.size() % columns != 0) throw std::invalid_argument("joint: the last row is ragged");
  double total = 0;
  for (double weight : joint) {
    if (!(weight >= 0)) throw std::invalid_argument("joint: a weight is negative or NaN");
    total += weight;
  }
  if (!(total > 0)) throw std::invalid_argument("joint: the total is not positive");

  const std::size_t rows = joint.size() / columns;
  std::vector<double> p_x(rows), p_y(columns);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    p_x[i / columns] += joint[i] / total;
    p_y[i % columns] += joint[i] / total;
  }
  double largest = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    largest = std::max(largest, std::abs(joint[i] / total - p_x[i / columns] * p_y[i % columns]));
  }
  return largest;
}

// 1.8 --------------------------------------------------------------------------------------------
//
// The definition would be
//
//   Moments all;
//   for (double value : x) add(all, value);
//
// and every step of it waits for a division that waits for the step before. Here nothing waits:
//
// * The data are taken in blocks that stay in the first-level cache, so that two passes over each
//   cost one trip to memory, and a block's own mean is known before its deviations are squared.
// * Sums run in 32 independent lanes, which the compiler turns into vector registers. A single sum
//   would wait about four cycles for each addition to finish before it could begin the next.
// * Means are carried as offsets from one common shift near the data. Block means near 1e9 would
//   have been rounded to 1e-7 before they are compared; their offsets are small and keep all
//   digits.

namespace {

constexpr std::size_t block_size = 1024;  // 8 KB
constexpr std::size_t lanes = 32;

/// Sum of term(value) over `x`, in independent lanes.
template <class Term>
double sum_of(std::span<const double> x, Term term) {
  std::array<double, lanes> sums{};
  std::size_t i = 0;
  for (; i + lanes <= x.size(); i += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += term(x[i + lane]);
  }
  for (; i < x.size(); ++i) sums[i % lanes] += term(x[i]);
  for (std::size_t width = lanes / 2; width > 0; width /= 2) {
    for (std::size_t lane = 0; lane < width; ++lane) sums[lane] += sums[lane + width];
  }
  return sums[0];
}

/// A value near the data: the mean of up to 64 of them, spread from the first to the last.
double shift_near(std::span<const double> x) {
  const std::size_t count = std::min<std::size_t>(x.size(), 64);
  double shift = 0;
  for (std::size_t i = 0; i < count; ++i) {
    shift += x[i * x.size() / count] / static_cast<double>(count);
  }
  return shift;
}

}  // namespace

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double shift = shift_near(x);
  Moments all;  // its mean is an offset from the shift until the end
  for (std::size_t first = 0; first < x.size(); first += block_size) {
    const auto block = x.subspan(first, std::min(block_size, x.size() - first));
    const double offset = sum_of(block, [=](double value) { return value - shift; }) /
                          static_cast<double>(block.size());
    const double m2 = sum_of(block, [=](double value) {
      const double deviation = value - shift - offset;
      return deviation * deviation;
    });
    all = merge(all, {block.size(), offset, m2});
  }
  all.mean += shift;
  return all;
}

}  // namespace mc
