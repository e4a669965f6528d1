// alternative: every sum keeps what its additions round away, after Kahan and Neumaier

#include "variance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Neumaier 1974, "Rundungsfehleranalyse einiger Verfahren zur Summation endlicher Summen".
class Sum {
 public:
  Sum& operator+=(double value) {
    const double next = sum_ + value;
    lost_ += std::abs(sum_) >= std::abs(value) ? (sum_ - next) + value : (value - next) + sum_;
    sum_ = next;
    return *this;
  }
  operator double() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

}  // namespace

double mean(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  Sum sum;
  for (double value : x) sum += value;
  if (std::isfinite(sum)) return sum / n;
  Sum small;
  for (double value : x) small += value * 0x1p-64;
  constexpr double largest = std::numeric_limits<double>::max() * 0x1p-64;
  return std::clamp(small / n, -largest, largest) * 0x1p64;  // NaN stays NaN
}

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  Sum sum, squares;
  for (double value : x) {
    sum += value;
    squares += value * value;
  }
  const double mean = sum / n;
  return (squares - n * mean * mean) / (n - 1);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto n = static_cast<double>(x.size());
  const double center = mean(x);
  Sum off, m2;
  for (double value : x) {
    off += value - center;
    m2 += (value - center) * (value - center);
  }
  return {x.size(), center, std::max(m2 - off * off / n, 0.0)};
}

double variance_two_pass(std::span<const double> x) {
  return variance(moments(x));
}

void add(Moments& moments, double x) {
  ++moments.count;
  const auto n = static_cast<double>(moments.count);
  const double mean = moments.mean + (x - moments.mean) / n;
  moments.m2 += (x - moments.mean) * (x - mean);
  moments.mean = mean;
}

double variance(const Moments& moments) {
  if (moments.count < 2) return nan;
  return moments.m2 / static_cast<double>(moments.count - 1);
}

Moments merge(const Moments& a, const Moments& b) {
  if (a.count < b.count) return merge(b, a);
  if (b.count == 0) return a;
  const auto n_a = static_cast<double>(a.count), n_b = static_cast<double>(b.count);
  const double share = n_b / (n_a + n_b);
  const double apart = b.mean - a.mean;
  Sum m2;
  m2 += apart * (share * n_a) * apart;
  m2 += b.m2;
  m2 += a.m2;
  return {a.count + b.count, a.mean - share * a.mean + share * b.mean, m2};
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x, y: not of one size");
  if (x.size() < 2) return nan;
  const double mean_x = mean(x), mean_y = mean(y);
  Sum products;
  for (std::size_t i = 0; i < x.size(); ++i) products += (x[i] - mean_x) * (y[i] - mean_y);
  return products / static_cast<double>(x.size() - 1);
}

double dependence(std::span<const double> joint, std::size_t columns) {
  if (columns == 0) throw std::invalid_argument("columns must not be 0");
  if (joint.size() % columns != 0) throw std::invalid_argument("joint has a ragged last row");
  Sum total;
  std::vector<Sum> rows(joint.size() / columns), of_column(columns);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    if (!(joint[i] >= 0) || std::isinf(joint[i]))
      throw std::invalid_argument("joint has a negative, infinite or NaN weight");
    total += joint[i];
    rows[i / columns] += joint[i];
    of_column[i % columns] += joint[i];
  }
  if (!(total > 0)) throw std::invalid_argument("joint has no positive weight");
  double largest = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    const double product = rows[i / columns] / total * (of_column[i % columns] / total);
    largest = std::max(largest, std::abs(joint[i] / total - product));
  }
  return largest;
}

}  // namespace mc
