#pragma once
// The lights that 2.7 is judged under, and what is known of them in closed form.

#include "checks/support/checks.hpp"
#include "checks/support/rect_light_exact.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {

struct Placed {
  RectLight light;
  std::string where;
};

/// Over the receiver: the one of the handout.
inline Placed above(Rng& rng) {
  RectLight light;
  light.radiance = uniform(rng, 0.5, 5);
  return {light, "above"};
}

/// A light whose lower corner and sides lie in these intervals, at such a height.
inline RectLight light_in(Interval x, Interval y, Interval side, Interval height, Rng& rng) {
  RectLight light;
  light.x0 = uniform(rng, x.low, x.high);
  light.x1 = light.x0 + uniform(rng, side.low, side.high);
  light.y0 = uniform(rng, y.low, y.high);
  light.y1 = light.y0 + uniform(rng, side.low, side.high);
  light.height = uniform(rng, height.low, height.high);
  light.radiance = uniform(rng, 0.5, 5);
  return light;
}

/// Somewhere else, with a corner near the receiver's normal; not so near that a few points carry
/// everything.
inline Placed aside(Rng& rng) {
  RectLight light = light_in({0.1, 0.5}, {0.1, 0.5}, {0.5, 2}, {0.7, 2}, rng);
  light.y0 = -std::exchange(light.y1, -light.y0);
  return {light, "aside"};
}

/// Low and far away: seen, and seeing, at two to three degrees.
inline Placed grazing(Rng& rng) {
  return {light_in({4, 5}, {-1, 0}, {1, 2}, {0.2, 0.25}, rng), "at a grazing angle"};
}

/// Everything that is lower than 11 to 18 degrees on one side. The plane x >= k h gives a share of
/// (1 - sin(atan(k))) / 2 of the whole sky: 1 to 2.6 %.
inline Placed half_sky_aside(Rng& rng) {
  RectLight light{0, 1e15, -1e15, 1e15, uniform(rng, 0.5, 2), uniform(rng, 0.5, 5)};
  light.x0 = light.height * uniform(rng, 3, 5);
  return {light, "at a grazing angle"};
}

/// A quarter of the sky.
inline Placed quarter_sky(unsigned quadrant, Rng& rng) {
  RectLight light{0, 1e15, 0, 1e15, uniform(rng, 0.5, 2), uniform(rng, 0.5, 5)};
  if (quadrant % 2 == 1) light.x0 = -std::exchange(light.x1, 0);
  if (quadrant / 2 == 1) light.y0 = -std::exchange(light.y1, 0);
  return {light, "in quadrant " + std::to_string(quadrant)};
}

/// What a point of the light gives that is this far, squared, from the point of the light's plane
/// above the receiver: area · radiance · height^2 / (square + height^2)^2.
inline double at_square_distance(const RectLight& light, double square) {
  const double distance2 = square + light.height * light.height;
  return area(light) * light.radiance * light.height * light.height / (distance2 * distance2);
}

/// How far, squared, a point is that gives `value`; NaN where nothing gives that.
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
  const double flat = b < r ? std::min(a, std::sqrt(r * r - b * b)) : 0;  // up to here y bounds it
  return sign * (b * flat + under_arc(a) - under_arc(flat));
}

/// The share of the light within this distance, squared, of the point above the receiver.
inline double share_within(const RectLight& light, double square) {
  if (!(square > 0)) return 0;
  const double r = std::sqrt(square);
  const double inside =
      disk_in_corner(light.x1, light.y1, r) - disk_in_corner(light.x0, light.y1, r) -
      disk_in_corner(light.x1, light.y0, r) + disk_in_corner(light.x0, light.y0, r);
  return inside / area(light);
}

/// The solid angle that the light fills, in closed form.
inline double solid_angle(const RectLight& light) {
  const double h = light.height;
  const auto corner = [=](double x, double y) {
    return std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h)));
  };
  return corner(light.x1, light.y1) - corner(light.x0, light.y1) - corner(light.x1, light.y0) +
         corner(light.x0, light.y0);
}

/// What one uniform point of the light gives.
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

}  // namespace mc::checks
