#pragma once
// The irradiance under a rectangular light, in closed form, and other properties of such a light.

#include <cmath>
#include <numbers>

#include "checks/support/domain.hpp"
#include "checks/support/quadrature.hpp"
#include "common/estimation.hpp"
#include "common/rect_light.hpp"

namespace mc::checks {

/// A random light whose lower corner, side lengths and height lie in these intervals.
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

/// The integral over the light of a function whose antiderivative in x and y is `corner(x, y)`.
template <class Corner>
double over_corners(const RectLight& light, Corner corner) {
  return corner(light.x1, light.y1) - corner(light.x0, light.y1) - corner(light.x1, light.y0) +
         corner(light.x0, light.y0);
}

/// Irradiance at the origin: Lambert's polygon formula, which for a rectangle parallel to the
/// receiver is a sum over its corners (Howell's catalog of configuration factors, B-3, B-4).
inline double irradiance(const RectLight& light) {
  const double h = light.height;
  return light.radiance * over_corners(light, [=](double x, double y) {
           const double a = std::sqrt(h * h + x * x), b = std::sqrt(h * h + y * y);
           return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / 2;
         });
}

inline double area(const RectLight& light) {
  return (light.x1 - light.x0) * (light.y1 - light.y0);
}

/// The integral and the mean of f(x, y) over the light; f is smooth on the scale of its height.
template <class Function>
double integral_over(const RectLight& light, Function f) {
  return integral(light.x0, light.x1, light.height, [&](double x) {
    return integral(light.y0, light.y1, light.height, [&](double y) { return f(x, y); });
  });
}
template <class Function>
double mean_over(const RectLight& light, Function f) {
  return integral_over(light, f) / area(light);
}

}  // namespace mc::checks
