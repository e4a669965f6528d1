// alternative: long double throughout, but for the textbook formula, which is asked for in double

#include "variance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

long double sum_of(std::span<const double> x) {
  long double sum = 0;
  for (double value : x) sum += value;
  return sum;
}

}  // namespace

double mean(std::span<const double> x) {
  const auto n = static_cast<long double>(x.size());
  const auto sum = static_cast<double>(sum_of(x) / n);
  if (x.empty() || std::isfinite(sum)) return sum;
  long double shares = 0;  // where long double reaches no further than double
  for (double value : x) shares += value / n;
  return static_cast<double>(shares);
}

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<double>(x.size());
  double mean = 0;
  double mean_of_squares = 0;
  for (double value : x) {
    mean += value / n;
    mean_of_squares += value * value / n;
  }
  return (mean_of_squares - mean * mean) * n / (n - 1);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto n = static_cast<long double>(x.size());
  const long double center = sum_of(x) / n;
  long double m2 = 0;
  long double off = 0;
  for (double value : x) {
    m2 += (value - center) * (value - center);
    off += value - center;
  }
  m2 = std::max(m2 - off * off / n, 0.0L);
  return {x.size(), static_cast<double>(center), static_cast<double>(m2)};
}

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto n = static_cast<long double>(x.size());
  const long double center = sum_of(x) / n;
  long double m2 = 0;
  long double off = 0;
  for (double value : x) {
    m2 += (value - center) * (value - center);
    off += value - center;
  }
  return static_cast<double>(std::max(m2 - off * off / n, 0.0L) / (n - 1));
}

void add(Moments& moments, double x) {
  ++moments.count;
  const long double before = static_cast<long double>(x) - moments.mean;
  const long double mean = moments.mean + before / static_cast<long double>(moments.count);
  moments.m2 = static_cast<double>(moments.m2 + before * (x - mean));
  moments.mean = static_cast<double>(mean);
}

double variance(const Moments& moments) {
  if (moments.count < 2) return nan;
  return static_cast<double>(moments.m2 / static_cast<long double>(moments.count - 1));
}

Moments merge(const Moments& a, const Moments& b) {
  if (a.count == 0 || b.count == 0) return a.count == 0 ? b : a;
  const auto n_a = static_cast<long double>(a.count), n_b = static_cast<long double>(b.count);
  const long double apart = static_cast<long double>(b.mean) - a.mean;
  const long double m2 = a.m2 + b.m2 + apart * apart * n_a * n_b / (n_a + n_b);
  return {a.count + b.count, static_cast<double>((n_a * a.mean + n_b * b.mean) / (n_a + n_b)),
          static_cast<double>(m2)};
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("the sizes of x and y");
  if (x.size() < 2) return nan;
  const auto n = static_cast<long double>(x.size());
  const long double mean_x = sum_of(x) / n, mean_y = sum_of(y) / n;
  long double products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) products += (x[i] - mean_x) * (y[i] - mean_y);
  return static_cast<double>(products / (n - 1));
}

double dependence(std::span<const double> joint, std::size_t columns) {
  if (columns == 0) throw std::invalid_argument("columns: 0");
  if (joint.size() % columns > 0) throw std::invalid_argument("joint is not full rows of columns");
  if (std::any_of(joint.begin(), joint.end(),
                  [](double weight) { return !(weight >= 0) || std::isinf(weight); })) {
    throw std::invalid_argument("weights are finite and not negative");
  }
  const long double total = sum_of(joint);
  if (total <= 0) throw std::invalid_argument("the total must be positive");
  std::vector<long double> p_x(joint.size() / columns), p_y(columns);
  for (std::size_t i = 0; i < joint.size(); ++i) {
    p_x[i / columns] += joint[i] / total;
    p_y[i % columns] += joint[i] / total;
  }
  long double largest = 0;
  for (std::size_t i = 0; i < joint.size(); ++i) {
    largest = std::max(largest, std::abs(joint[i] / total - p_x[i / columns] * p_y[i % columns]));
  }
  return static_cast<double>(largest);
}

}  // namespace mc
