#pragma once
// The irradiance under a rectangular light, in closed form, and what else its checks need to know.

#include <cmath>
#include <numbers>

#include "common/rect_light.hpp"

namespace mc::checks {

/// Irradiance at the origin: Lambert's polygon formula, which for a rectangle parallel to the
/// receiver is a sum over its corners (Howell, "A catalog of radiation heat transfer configuration
/// factors", B-3 and B-4).
inline double irradiance(const RectLight& light) {
  const double h = light.height;
  const auto corner = [=](double x, double y) {
    const double a = std::sqrt(h * h + x * x), b = std::sqrt(h * h + y * y);
    return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / 2;
  };
  return light.radiance * (corner(light.x1, light.y1) - corner(light.x0, light.y1) -
                           corner(light.x1, light.y0) + corner(light.x0, light.y0));
}

inline double area(const RectLight& light) {
  return (light.x1 - light.x0) * (light.y1 - light.y0);
}

/// The mean of f(x, y) over the light: Simpson's rule on 128 x 128 panels, which for what is smooth
/// on the scale of its height leaves 1e-8.
template <class Function>
double mean_over(const RectLight& light, Function f) {
  constexpr int panels = 128;
  const auto weight = [](int i) { return i == 0 || i == panels ? 1 : i % 2 == 1 ? 4 : 2; };
  double sum = 0;
  for (int i = 0; i <= panels; ++i) {
    for (int j = 0; j <= panels; ++j) {
      sum += weight(i) * weight(j) *
             f(light.x0 + (light.x1 - light.x0) * i / panels,
               light.y0 + (light.y1 - light.y0) * j / panels);
    }
  }
  return sum / (9.0 * panels * panels);
}

}  // namespace mc::checks
