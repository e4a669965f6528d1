#pragma once
// The lights of 2.7 and 2.9, and the exact distributions of their samples.

#include "checks/independent/functions.hpp"
#include "checks/support/rect_light_exact.hpp"

namespace mc::checks {

inline constexpr double pi = std::numbers::pi;
using Estimates = std::vector<Estimate>;

struct PlacedLight {
  RectLight light;
  std::string where;
};

inline PlacedLight above(Rng& rng) {
  return {{.radiance = uniform(rng, 0.5, 5)}, "above the receiver"};
}

/// A light with a corner near the receiver's normal, but not so close that a few points dominate.
inline PlacedLight aside(Rng& rng) {
  RectLight light = light_in({0.1, 0.5}, {0.1, 0.5}, {0.5, 2}, {0.7, 2}, rng);
  light.y0 = -std::exchange(light.y1, -light.y0);
  return {light, "to one side"};
}

/// A low and distant light, at two to three degrees above the horizon.
inline PlacedLight grazing(Rng& rng) {
  return {light_in({4, 5}, {-1, 0}, {1, 2}, {0.2, 0.25}, rng), "at a grazing angle"};
}

/// Everything beyond the plane x = k h. It has a fraction (1 - sin(atan(k))) / 2 of the sky: 1 to
/// 2.6 % for k from 3 to 5, and 24 to 36 of 1.6 million directions for k from 105 to 130.
inline PlacedLight half_sky_aside(double least, double most, Rng& rng) {
  RectLight light{0, 1e15, -1e15, 1e15, uniform(rng, 0.5, 2), uniform(rng, 0.5, 5)};
  light.x0 = light.height * uniform(rng, least, most);
  return {light, "at a grazing angle"};
}

inline PlacedLight quarter_sky(unsigned quadrant, Rng& rng) {
  RectLight light{0, 1e15, 0, 1e15, uniform(rng, 0.5, 2), uniform(rng, 0.5, 5)};
  if (quadrant % 2 == 1) light.x0 = -std::exchange(light.x1, 0);
  if (quadrant / 2 == 1) light.y0 = -std::exchange(light.y1, 0);
  return {light, "in quadrant " + std::to_string(quadrant)};
}

/// The value at a point of the light, given its squared distance from the point of the light's
/// plane above the receiver: area · radiance · height^2 / (square + height^2)^2.
inline double at_square_distance(const RectLight& light, double square) {
  const double distance2 = square + light.height * light.height;
  return area(light) * light.radiance * light.height * light.height / (distance2 * distance2);
}

/// The squared distance at which a point has this value; NaN if there is none.
inline double square_distance_of(const RectLight& light, double value) {
  const double h2 = light.height * light.height;
  return std::sqrt(area(light) * light.radiance * h2 / value) - h2;
}

inline double nearest(const RectLight& light) {
  const double x = std::max({light.x0, -light.x1, 0.0}), y = std::max({light.y0, -light.y1, 0.0});
  return x * x + y * y;
}
inline double farthest(const RectLight& light) {
  const double x = std::max(-light.x0, light.x1), y = std::max(-light.y0, light.y1);
  return x * x + y * y;
}

/// The area of the disk of radius r around the origin inside [0, x] x [0, y]; odd in x and in y.
inline double disk_in_corner(double x, double y, double r) {
  const double sign = (x < 0) == (y < 0) ? 1 : -1;
  const double a = std::min(std::abs(x), r), b = std::abs(y);
  const auto under_arc = [=](double at) {  // the integral of sqrt(r^2 - x^2) from 0
    return (at * std::sqrt(std::max(0.0, r * r - at * at)) +
            r * r * std::asin(std::min(1.0, at / r))) /
           2;
  };
  const double flat = b < r ? std::min(a, std::sqrt(r * r - b * b)) : 0;  // up to here bounded by y
  return sign * (b * flat + under_arc(a) - under_arc(flat));
}

/// The fraction of the light within this squared distance of the point above the receiver.
inline double share_within(const RectLight& light, double square) {
  if (!(square > 0)) return 0;
  const auto f = [r = std::sqrt(square)](double x, double y) { return disk_in_corner(x, y, r); };
  return over_corners(light, f) / area(light);
}

inline double solid_angle(const RectLight& light) {
  const double h = light.height;
  return over_corners(light, [=](double x, double y) {
    return std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h)));
  });
}

/// The value at one uniform point of the light.
inline Population of_area(const RectLight& light) {
  const auto moment = [&](double k) {
    return mean_over(light, [&](double x, double y) {
      return std::pow(at_square_distance(light, x * x + y * y), k);
    });
  };
  Population x = population(moment(1), moment(2), moment(3), moment(4));
  x.mean = irradiance(light);
  return x;
}

/// What 2.9 adds at a point of the light, f / (p_area + p_hemisphere), given its squared distance
/// as above: with distance d, radiance / (d^4 / (area · height^2) + 1 / pi).
inline double balanced_at(const RectLight& light, double square) {
  const double distance2 = square + light.height * light.height;
  const double ratio = distance2 / light.height;
  return light.radiance / (ratio * ratio / area(light) + 1 / pi);
}

/// The squared distance at which a point has this balanced value; NaN if there is none.
inline double square_distance_of_balanced(const RectLight& light, double value) {
  const double ratio2 = area(light) * (light.radiance / value - 1 / pi);
  return light.height * (std::sqrt(ratio2) - light.height);
}

/// The value of one pair of 2.9, a sum of two independent terms.
inline Population of_pair(const RectLight& light) {
  const auto power = [&](double x, double y, double k) {
    return std::pow(balanced_at(light, x * x + y * y), k);
  };
  const auto by_point = [&](double k) {
    return mean_over(light, [&](double x, double y) { return power(x, y, k); });
  };
  const auto by_direction = [&](double k) {
    return integral_over(light, [&](double x, double y) {
      const double ratio = (x * x + y * y) / light.height + light.height;
      return power(x, y, k) / (ratio * ratio * pi);  // its density on the light
    });
  };
  const auto moments_of = [](auto moment) {
    return population(moment(1.0), moment(2.0), moment(3.0), moment(4.0));
  };
  const Population a = moments_of(by_point), b = moments_of(by_direction);
  const double variance = a.variance + b.variance;
  const double fourth = a.kurtosis * a.variance * a.variance + 6 * a.variance * b.variance +
                        b.kurtosis * b.variance * b.variance;
  return {irradiance(light), variance, fourth / (variance * variance)};
}

}  // namespace mc::checks
