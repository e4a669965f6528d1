// alternative: everything is built on add and merge; a second pass adds deviations from the mean

#include "variance.hpp"
#define mean(x) solution_mean(x)
#define variance_two_pass solution_variance_two_pass
#define covariance solution_covariance
#define moments solution_moments
#include "solutions/variance.cpp"

#include <algorithm>
#include <cmath>
#undef mean
#undef variance_two_pass
#undef covariance
#undef moments

namespace mc {
namespace {

Moments moments_about(std::span<const double> x, double center) {
  Moments all;
  for (double value : x) add(all, value - center);
  return all;
}

}  // namespace

double mean(std::span<const double> x) {
  if (x.empty()) return nan;
  Moments all;
  for (double value : x) add(all, value);
  if (std::isfinite(all.mean)) return all.mean;

  double running = 0;  // x - running overflowed: take the two apart
  double count = 0;
  for (double value : x) {
    ++count;
    running += value / count - running / count;
  }
  return running;
}

double variance_two_pass(std::span<const double> x) {
  return variance(moments_about(x, mean(x)));
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("x, y");
  Moments of_x, of_y;
  double products = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double before = x[i] - of_x.mean;
    add(of_x, x[i]);
    add(of_y, y[i]);
    products += before * (y[i] - of_y.mean);
  }
  return x.size() < 2 ? nan : products / static_cast<double>(x.size() - 1);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const double center = mean(x);
  Moments all;
  for (std::size_t first = 0; first < x.size(); first += 100) {
    all = merge(
        all, moments_about(x.subspan(first, std::min<std::size_t>(100, x.size() - first)), center));
  }
  all.mean += center;
  return all;
}

}  // namespace mc
