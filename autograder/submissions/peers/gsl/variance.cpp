// peer: the GNU Scientific Library: gsl_stats_mean, gsl_stats_variance, gsl_stats_covariance
// fails: 1.3 two passes keep their digits
// fails: 1.8 the moments keep their digits on hard data
// because: gsl_stats_variance squares deviations from a rounded mean and does not correct for it:
//   n times the squared rounding error of the mean remains, 1e-7 of the variance near 1e15
#include "variance.hpp"

#include <limits>
#include <stdexcept>

#include <gsl/gsl_statistics_double.h>

#include "common/todo.hpp"

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double mean(std::span<const double> x) {
  return x.empty() ? nan : gsl_stats_mean(x.data(), 1, x.size());
}

double variance_two_pass(std::span<const double> x) {
  return x.size() < 2 ? nan : gsl_stats_variance(x.data(), 1, x.size());
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x and y: sizes differ");
  return x.size() < 2 ? nan : gsl_stats_covariance(x.data(), 1, y.data(), 1, x.size());
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double center = gsl_stats_mean(x.data(), 1, x.size());
  return {x.size(), center, gsl_stats_tss_m(x.data(), 1, x.size(), center)};
}

// GSL has no E{X^2} - E{X}^2, and its running statistics cannot be begun from given moments, nor
// merged.
double variance_textbook(std::span<const double>) {
  throw todo("1.2");
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
