// peer: Boost.Accumulators: tag::mean, tag::lazy_variance, tag::variance
// fails: 1.1 the mean is finite
// because: tag::mean adds first and divides then: the sum overflows where the mean does not
// fails: 1.3 two passes keep their digits
// fails: 1.3 the variance of constant data is zero
// fails: 1.3 two passes on hard cases
// because: tag::variance is a running one: it rounds its mean at every value
// fails: 1.8 the moments keep their digits on hard data
// because: tag::lazy_variance is E{X^2} - E{X}^2, two large numbers nearly equal (NumAcc1, 3 and 4)
#include "variance.hpp"

#include <limits>
#include <stdexcept>

#include <boost/accumulators/framework/accumulator_set.hpp>
#include <boost/accumulators/statistics/mean.hpp>
#include <boost/accumulators/statistics/stats.hpp>
#include <boost/accumulators/statistics/variance.hpp>

#include "common/todo.hpp"

namespace mc {
namespace {

namespace acc = boost::accumulators;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class... Statistics>
auto all_of(std::span<const double> x) {
  acc::accumulator_set<double, acc::stats<Statistics...>> set;
  for (const double value : x) set(value);
  return set;
}

/// Boost divides by n.
double unbiased(double variance, std::size_t n) {
  return n < 2 ? nan : variance * static_cast<double>(n) / static_cast<double>(n - 1);
}

}  // namespace

double mean(std::span<const double> x) {
  return x.empty() ? nan : acc::mean(all_of<acc::tag::mean>(x));
}

double variance_textbook(std::span<const double> x) {
  return unbiased(acc::lazy_variance(all_of<acc::tag::lazy_variance>(x)), x.size());
}

double variance_two_pass(std::span<const double> x) {
  return unbiased(acc::variance(all_of<acc::tag::variance>(x)), x.size());
}

/// There is a tag::covariance, but its templates take the compiler 500 MB.
double covariance(std::span<const double>, std::span<const double>) {
  throw todo("1.6");
}

/// The fast one of Boost's two variances, which is the one that its documentation begins with.
Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto set = all_of<acc::tag::mean, acc::tag::lazy_variance>(x);
  return {x.size(), acc::mean(set), acc::lazy_variance(set) * static_cast<double>(x.size())};
}

// An accumulator_set cannot be begun from given moments, nor merged with another.
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
