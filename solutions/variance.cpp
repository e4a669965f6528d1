// Lab 1 · variance: the reference solution. The speed task has its definition first, then a faster
// version with the reason why it is faster.

#include "variance.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

// 1.1 ---------------------------------------------------------------------------------------------

double mean(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  double sum = 0;
  for (double value : x) sum += value;
  if (std::isfinite(sum)) return sum / n;  // 0/0 is NaN: the mean of nothing

  // The sum overflowed; a running mean does not, since it stays between the smallest value and the
  // largest. Shares x / n are rounded: three of the largest double add up to infinity.
  double running = 0, count = 0;
  for (double value : x) {
    ++count;
    running += value / count - running / count;
  }
  return running;
}

// 1.2 ---------------------------------------------------------------------------------------------

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

// 1.3 ---------------------------------------------------------------------------------------------

double variance_two_pass(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  if (n < 2) return nan;
  const double center = mean(x);
  double m2 = 0;
  double correction = 0;  // the mean was rounded, so the deviations from it do not sum to zero
  for (double value : x) {
    const double deviation = value - center;
    m2 += deviation * deviation;
    correction += deviation;
  }
  return std::max(m2 - correction * correction / n, 0.0) / (n - 1);  // of NaN and 0, NaN
}

// 1.4 ---------------------------------------------------------------------------------------------

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

// 1.5 ---------------------------------------------------------------------------------------------

Moments merge(const Moments& a, const Moments& b) {
  if (a.count < b.count) return merge(b, a);
  if (b.count == 0) return a;
  const auto n_a = static_cast<double>(a.count);
  const auto n_b = static_cast<double>(b.count);
  const double share = n_b / (n_a + n_b);
  const double apart = b.mean - a.mean;
  return {a.count + b.count,
          // From the larger part's mean: a small step is a small rounding error. Two shares, since
          // the distance of two means may overflow where the step does not.
          a.mean + (b.mean * share - a.mean * share),
          // The weight first: the square of a small distance may be less than any double.
          a.m2 + b.m2 + apart * (n_a * share) * apart};
}

// 1.6 ---------------------------------------------------------------------------------------------

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

// 1.7 ---------------------------------------------------------------------------------------------

double dependence(std::span<const double> joint, std::size_t columns) {
  if (columns == 0) throw std::invalid_argument("columns: there are none");
  if (joint.size() % columns != 0) throw std::invalid_argument("joint: the last row is ragged");
  double total = 0;
  for (double weight : joint) {
    if (!(weight >= 0 && std::isfinite(weight))) {
      throw std::invalid_argument("joint: a weight is negative, infinite or NaN");
    }
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

// 1.8 ---------------------------------------------------------------------------------------------

namespace definition {
Moments moments(std::span<const double> x) {
  Moments all;
  for (double value : x) add(all, value);
  return all;
}
}  // namespace definition

// Each step above waits for a division, which waits for the step before it. Here the additions are
// independent:
//
// * All deviations are from one shift, a value near the data. Then sums of d and of d^2 are enough,
//   which is the textbook formula again. Its relative error grows with (mean - shift)^2 / variance,
//   which is large for shift = 0 and small for a shift near the mean.
// * Both sums run in independent lanes, several to a vector register. A single sum would wait four
//   cycles for each addition to finish before it could begin the next.
// * Blocks are short, so that no sum collects many rounding errors, and they are merged as in 1.5.
//   Their means stay offsets from the shift until the end: near 1e9 a mean is rounded to 1e-7, a
//   small offset to far less.

namespace {

constexpr std::size_t block_size = 4096;

/// A value near the data, and near it even if one value is far off: the mean of 32 of them, spread
/// over the data, without the smallest and the largest. Of up to 64 values, the mean of four will
/// do: if one of the four is off by D, n (D/4)^2 are lost of about D^2, a factor of 4.
double shift_near(std::span<const double> x) {
  constexpr std::size_t count = 32;
  const std::size_t n = x.size();
  if (n <= 2 * count) return (x[0] / 4 + x[n / 4] / 4) + (x[n / 2] / 4 + x[n - 1] / 4);
  const std::size_t step = n / count;
  const double share = 1 / static_cast<double>(count - 2);
  double sum = 0, smallest = x[0], largest = x[0];
  for (std::size_t i = 0; i < count; ++i) {
    const double value = x[i * step];
    sum += value * share;
    smallest = std::min(smallest, value);
    largest = std::max(largest, value);
  }
  return sum - smallest * share - largest * share;
}

/// A register of doubles, which are added and multiplied at once, by an extension that GCC and
/// Clang share: arrays as in 2.8 would stay in memory, and take five times as long. Four sums in
/// turn, since an addition takes four cycles.
#ifdef __AVX__
constexpr std::size_t lanes = 4, in_turn = 4;
#else
constexpr std::size_t lanes = 2, in_turn = 4;
#endif
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

/// The moments of a block, its mean as an offset from `shift`.
inline Moments moments_from(double shift, std::span<const double> block) {
  Lanes sum[in_turn] = {}, squares[in_turn] = {};
  const std::size_t whole = block.size() - block.size() % (in_turn * lanes);
  for (std::size_t i = 0; i < whole; i += in_turn * lanes) {
    for (std::size_t k = 0; k < in_turn; ++k) {
      Lanes d;
      std::memcpy(&d, &block[i + k * lanes], sizeof d);
      d -= shift;
      sum[k] += d;
      squares[k] += d * d;
    }
  }
  double all = 0, all_squares = 0;
  if (whole > 0) {
    const Lanes sums = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    const Lanes all_lanes = (squares[0] + squares[1]) + (squares[2] + squares[3]);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      all += sums[lane];
      all_squares += all_lanes[lane];
    }
  }
  for (const double value : block.subspan(whole)) {
    all += value - shift;
    all_squares += (value - shift) * (value - shift);
  }
  const double offset = all / static_cast<double>(block.size());
  return {block.size(), offset, std::max(all_squares - all * offset, 0.0)};
}

}  // namespace

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double shift = shift_near(x);
  Moments all = moments_from(shift, x.first(std::min(block_size, x.size())));
  for (std::size_t first = block_size; first < x.size(); first += block_size) {
    const std::size_t size = std::min(block_size, x.size() - first);
    all = merge(all, moments_from(shift, x.subspan(first, size)));
  }
  return {all.count, shift + all.mean, all.m2};
}

}  // namespace mc
