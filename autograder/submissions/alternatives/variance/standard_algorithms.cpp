// alternative: std::accumulate, std::reduce, std::transform_reduce and ranges in place of loops

#include "variance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <ranges>
#include <stdexcept>
#include <vector>

namespace mc {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double size_of(std::span<const double> x) {
  return static_cast<double>(x.size());
}

std::vector<double> deviations(std::span<const double> x) {
  const double center = mean(x);
  std::vector<double> d(x.size());
  std::ranges::transform(x, d.begin(), [=](double value) { return value - center; });
  return d;
}

double corrected(const std::vector<double>& dx, const std::vector<double>& dy) {
  return std::inner_product(dx.begin(), dx.end(), dy.begin(), 0.0) -
         std::reduce(dx.begin(), dx.end()) * std::reduce(dy.begin(), dy.end()) / size_of(dx);
}

}  // namespace

double mean(std::span<const double> x) {
  if (x.empty()) return nan;
  const auto largest = std::ranges::max(x, {}, [](double value) { return std::abs(value); });
  if (std::abs(largest) < 1e290) return std::accumulate(x.begin(), x.end(), 0.0) / size_of(x);
  const double mean = std::transform_reduce(x.begin(), x.end(), 0.0, std::plus<>(),
                                            [n = size_of(x)](double value) { return value / n; });
  constexpr double most = std::numeric_limits<double>::max();
  return std::isfinite(largest) ? std::clamp(mean, -most, most) : mean;
}

double variance_textbook(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const double squares = std::transform_reduce(x.begin(), x.end(), x.begin(), 0.0) / size_of(x);
  const double n = size_of(x);
  return n / (n - 1) * (squares - std::pow(mean(x), 2));
}

double variance_two_pass(std::span<const double> x) {
  if (x.size() < 2) return nan;
  const auto d = deviations(x);
  return std::max(corrected(d, d), 0.0) / (size_of(x) - 1);
}

void add(Moments& moments, double x) {
  moments = merge(moments, {1, x, 0});
}

double variance(const Moments& moments) {
  return moments.count < 2 ? nan : moments.m2 / static_cast<double>(moments.count - 1);
}

Moments merge(const Moments& a, const Moments& b) {
  if (b.count == 0) return a;
  const std::uint64_t count = a.count + b.count;
  const double share_a = static_cast<double>(a.count) / static_cast<double>(count);
  const double share_b = static_cast<double>(b.count) / static_cast<double>(count);
  return {
      count, std::lerp(a.mean, b.mean, share_b),
      a.m2 + b.m2 +
          std::pow((b.mean - a.mean) * std::sqrt(share_a * share_b * static_cast<double>(count)),
                   2)};
}

double covariance(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("covariance: x and y of unequal size");
  if (x.size() < 2) return nan;
  return corrected(deviations(x), deviations(y)) / (size_of(x) - 1);
}

double dependence(std::span<const double> joint, std::size_t columns) {
  if (columns == 0 || joint.size() % columns != 0) throw std::invalid_argument("columns");
  if (!std::ranges::all_of(joint, [](double weight) { return weight >= 0 && weight < INFINITY; })) {
    throw std::invalid_argument("joint: weights from 0");
  }
  const double total = std::accumulate(joint.begin(), joint.end(), 0.0);
  if (total <= 0) throw std::invalid_argument("joint: an empty table");
  const auto p = [&](std::size_t i) { return joint[i] / total; };
  const auto cells = std::views::iota(std::size_t{0}, joint.size());
  std::vector<double> p_x(joint.size() / columns), p_y(columns);
  std::ranges::for_each(cells, [&](std::size_t i) { p_x[i / columns] += p(i); });
  std::ranges::for_each(cells, [&](std::size_t i) { p_y[i % columns] += p(i); });
  const auto differences = cells | std::views::transform([&](std::size_t i) {
                             return std::abs(p(i) - p_x[i / columns] * p_y[i % columns]);
                           });
  return std::ranges::max(differences);
}

Moments moments(std::span<const double> x) {
  if (x.empty()) return {};
  const auto d = deviations(x);
  const double off = std::reduce(d.begin(), d.end()) / size_of(x);
  return {x.size(), mean(x) + off, std::max(corrected(d, d), 0.0)};
}

}  // namespace mc
