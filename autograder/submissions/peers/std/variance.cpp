// peer: the C++ standard library: std::accumulate, std::inner_product, a two-pass loop
// fails: 1.1 the mean is finite
// because: it adds first and divides then: the sum overflows where the mean does not
// fails: 1.3 two passes keep their digits
// fails: 1.3 the variance of constant data is zero
// because: the rounding of the mean is not taken back, as the corrected two-pass formula does
// fails: 1.8 the moments keep their digits on hard data
// because: the rounding of the mean adds to the squares and is not taken back (NumAcc4)
#include "variance.hpp"

#include <limits>
#include <numeric>
#include <stdexcept>

#include "common/todo.hpp"

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double sum_of(std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0.0);
}

double squares_around(double center, std::span<const double> x) {
  return std::accumulate(x.begin(), x.end(), 0.0, [=](double sum, double value) {
    return sum + (value - center) * (value - center);
  });
}

}  // namespace

double mean(std::span<const double> x) {
  return sum_of(x) / static_cast<double>(x.size());
}

double variance_textbook(std::span<const double> x) {
  const auto n = static_cast<double>(x.size());
  if (n < 2) return nan;
  const double squares = std::inner_product(x.begin(), x.end(), x.begin(), 0.0), all = mean(x);
  return (squares / n - all * all) * n / (n - 1);
}

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  return squares_around(mean(x), x) / static_cast<double>(x.size() - 1);
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  if (x.size() < 2) return nan;
  const double mean_x = mean(x), mean_y = mean(y);
  const double sum =
      std::transform_reduce(x.begin(), x.end(), y.begin(), 0.0, std::plus<>(),
                            [=](double a, double b) { return (a - mean_x) * (b - mean_y); });
  return sum / static_cast<double>(x.size() - 1);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double center = mean(x);
  return {x.size(), center, squares_around(center, x)};
}

void add(Moments&, double) {
  throw todo("1.4");
}
double variance(const Moments& moments) {
  if (moments.count < 2) return nan;
  return moments.m2 / static_cast<double>(moments.count - 1);
}
Moments merge(const Moments&, const Moments&) {
  throw todo("1.5");
}
double dependence(std::span<const double>, std::size_t) {
  throw todo("1.7");
}

}  // namespace mc
