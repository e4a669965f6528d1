// alternative: updates by Youngs and Cramer 1971, who keep a sum in place of a mean; covariance in
// one pass, with updates like Welford's

#include "variance.hpp"
#define variance_two_pass solution_variance_two_pass
#define add solution_add
#define covariance solution_covariance
#define moments solution_moments
#include "solutions/variance.cpp"
#undef variance_two_pass
#undef add
#undef covariance
#undef moments

namespace mc {
namespace {

/// Moments about a shift: sums of offsets and of their squared deviations.
Moments about(std::span<const double> x, double shift) {
  double sum = 0;
  double m2 = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto n = static_cast<double>(i + 1);
    const double value = x[i] - shift;
    sum += value;
    const double apart = n * value - sum;
    if (i > 0) m2 += apart * apart / (n * (n - 1));
  }
  return {x.size(), sum / static_cast<double>(x.size()), m2};
}

}  // namespace

double variance_two_pass(std::span<const double> x) {
  return variance(moments(x));
}

void add(Moments& moments, double x) {
  const auto n = static_cast<double>(++moments.count);
  if (n == 1) {
    moments.mean = x;
    moments.m2 = x - x;  // NaN for an infinity
    return;
  }
  const double sum = moments.mean * (n - 1) + x;
  const double apart = n * x - sum;
  moments.m2 += apart / n * (apart / (n - 1));
  moments.mean = sum / n;
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x.size() != y.size()");
  double mean_x = 0, mean_y = 0, products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto n = static_cast<double>(i + 1);
    const double before = x[i] - mean_x;
    mean_x += before / n;
    mean_y += (y[i] - mean_y) / n;
    products += before * (y[i] - mean_y);
  }
  return x.size() < 2 ? nan : products / (static_cast<double>(x.size()) - 1);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double shift = mean(x);
  Moments all = about(x, shift);
  all.mean += shift;
  return all;
}

}  // namespace mc
