#include <algorithm>
#include <cmath>

#include "bench/bench.hpp"

namespace mc::grader {
namespace {

/// f at x on the line through two points, all in the logarithms.
double between(double a, double f, double b, double g, double x) {
  return f * std::pow(g / f, std::log(x / a) / std::log(b / a));
}

}  // namespace

std::vector<Curve> curves_of(const std::vector<protocol::Row>& rows) {
  std::vector<Curve> curves;
  for (const protocol::Row& row : rows) {
    if (std::isnan(row.rmse) || std::isnan(row.ns)) continue;
    auto found = std::ranges::find_if(curves, [&](const Curve& curve) {
      return curve.method == row.method && curve.integrand == row.integrand;
    });
    if (found == curves.end()) found = curves.insert(found, {row.method, row.integrand, {}});
    found->points.push_back({static_cast<double>(row.n), row.rmse, row.ns});
  }
  for (Curve& curve : curves) std::ranges::stable_sort(curve.points, {}, &Curve::Point::n);
  return curves;
}

const Curve* find_curve(const std::vector<Curve>& curves, const std::string& method,
                        const std::string& integrand) {
  for (const Curve& curve : curves) {
    if (curve.method == method && curve.integrand == integrand) return &curve;
  }
  return nullptr;
}

std::optional<TimeToTarget> time_to(const Curve& curve, double target) {
  const auto& points = curve.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].rmse > target) continue;
    if (i == 0) return TimeToTarget{points[0].seconds(), TimeToTarget::or_less};
    const auto &before = points[i - 1], &after = points[i];
    return TimeToTarget{
        between(before.rmse, before.seconds(), after.rmse, after.seconds(), target)};
  }
  if (!curve.method.starts_with("independent") || points.empty()) return {};
  return TimeToTarget{points.back().seconds() * std::pow(points.back().rmse / target, 2),
                      TimeToTarget::by_law};
}

double error_within(const Curve& curve, double seconds) {
  for (std::size_t i = 1; i < curve.points.size(); ++i) {
    const auto &before = curve.points[i - 1], &after = curve.points[i];
    if (seconds < before.seconds()) break;
    if (seconds > after.seconds()) continue;
    return between(before.seconds(), before.rmse, after.seconds(), after.rmse, seconds);
  }
  return protocol::unknown;
}

double efficiency(const std::vector<Curve>& curves, const Curve& curve, const Curve::Point& point) {
  const Curve* const chance = find_curve(curves, "independent", curve.integrand);
  for (std::size_t i = 0; chance != nullptr && i < chance->points.size(); ++i) {
    const auto& other = chance->points[i];
    if (other.n < point.n) continue;  // Poisson disks only come close
    // The squared error of n independent points, in the time that n of them take.
    const double square = other.rmse * other.rmse * other.n / point.n;
    return square * other.ns / (point.rmse * point.rmse * point.ns);
  }
  return protocol::unknown;
}

}  // namespace mc::grader
