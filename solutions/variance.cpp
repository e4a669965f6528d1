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
  if (std::isfinite(sum)) return sum / n;  // 0/0 is NaN: the mean of an empty list

  // The sum overflowed. A running mean does not overflow, since it stays between the smallest and
  // the largest value. A sum of the quotients x / n would not do: they are rounded, and for three
  // values equal to the largest double they add up to infinity.
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
  const double distance = b.mean - a.mean;
  return {
      a.count + b.count,
      // Start from the larger part's mean: the step is then small, and so is its rounding error.
      // Each mean is weighted separately, since their distance may overflow.
      a.mean + (b.mean * share - a.mean * share),
      // Multiply by the weight first: the square of a small distance may underflow.
      a.m2 + b.m2 + distance * (n_a * share) * distance};
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
  return (products - deviations_x * deviations_y / n) / (n - 1);  // corrected as in 1.3
}

// 1.7 ---------------------------------------------------------------------------------------------

double dependence(std::span<const double> joint, std::size_t columns) {
  if (columns == 0) throw std::invalid_argument("columns: must be positive");
  if (joint.size() % columns != 0) throw std::invalid_argument("joint: the last row is ragged");
  double total = 0;
  for (double weight : joint) {
    if (!(weight >= 0 && std::isfinite(weight))) {
      throw std::invalid_argument("joint: a weight is negative, infinite or NaN");
    }
    total += weight;
  }
  if (!(total > 0)) throw std::invalid_argument("joint: the total is not positive");

  // The weights of rows and columns are added up first and divided once: a sum of quotients has the
  // rounding error of every quotient.
  std::vector<double> of_row(joint.size() / columns), of_column(columns);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    of_row[i / columns] += joint[i];
    of_column[i % columns] += joint[i];
  }
  double largest = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const double p_x = of_row[i / columns] / total, p_y = of_column[i % columns] / total;
    largest = std::max(largest, std::abs(joint[i] / total - p_x * p_y));
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

// Each step of the definition waits for a division, which waits for the previous step. In the
// faster version the additions are independent:
//
// * All deviations d are from one shift, a value near the data. Then the sums of d and of d^2 are
//   enough; this is the textbook formula again. Its relative error grows with (mean - shift)^2 /
//   variance, which is large for shift = 0 and small for a shift near the mean. If an outlier made
//   the shift a bad one, the result shows it, and a second pass with the mean as the shift follows.
// * Both sums are split into independent lanes, several per vector register. A single sum would
//   have to wait four cycles for each addition before it could start the next.
// * Blocks are short, so that no sum accumulates many rounding errors, and they are merged as in
//   1.5. Until the end their means are stored as offsets from the shift: near 1e9 a mean is rounded
//   to 1e-7, a small offset to far less.

namespace {

constexpr std::size_t block_size = 4096;

/// A vector register of doubles, by an extension of GCC and Clang. (Arrays as in 2.8 would stay in
/// memory, which takes five times as long.) Four registers take turns, since an addition has a
/// latency of four cycles.
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

/// The moments of x, its mean as an offset from `shift`.
Moments moments_in_blocks(double shift, std::span<const double> x) {
  Moments all = moments_from(shift, x.first(std::min(block_size, x.size())));
  for (std::size_t first = block_size; first < x.size(); first += block_size) {
    const std::size_t size = std::min(block_size, x.size() - first);
    all = merge(all, moments_from(shift, x.subspan(first, size)));
  }
  return all;
}

}  // namespace

Moments moments(std::span<const double> x) {
  const std::size_t n = x.size();
  if (n == 0) return {};
  double shift = (x[0] / 4 + x[n / 4] / 4) + (x[n / 2] / 4 + x[n - 1] / 4);
  Moments all = moments_in_blocks(shift, x);
  if (static_cast<double>(n) * all.mean * all.mean > 10 * all.m2) {  // false for NaN
    shift += all.mean;
    all = moments_in_blocks(shift, x);
  }
  return {n, shift + all.mean, all.m2};
}

}  // namespace mc
