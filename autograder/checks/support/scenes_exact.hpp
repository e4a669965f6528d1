#pragma once
// The exact moments of the scenes of labs/common/scenes.hpp, for any valid parameters, derived from
// the geometry and not from the scene's code. Means are in closed form; all moments of an indicator
// equal its mean; those of lights are integrals (Gauss-Legendre), accurate to 12 digits.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "checks/support/rect_light_exact.hpp"
#include "checks/support/statistics.hpp"
#include "common/scenes.hpp"

namespace mc::checks {

/// The mean of f(cos phi) over a circle: the trapezoidal rule converges fast for smooth periodic
/// functions.
template <class F>
double mean_around(int points, F f) {
  double sum = 0;
  for (int i = 0; i < points; ++i) sum += f(std::cos(2 * std::numbers::pi * i / points));
  return sum / points;
}

// Lights ------------------------------------------------------------------------------------------

/// Irradiance at the origin from a polygon of radiance 1 with vertices on or above the horizon z =
/// 0. Lambert's formula: half the sum, over the edges, of the angle that an edge subtends times the
/// cosine between its plane's normal and the receiver's. Signed by orientation.
inline double lambert(std::span<const scenes::Vector> polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const scenes::Vector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double x = p.y * q.z - p.z * q.y, y = p.z * q.x - p.x * q.z, z = p.x * q.y - p.y * q.x;
    const double sine = std::sqrt(x * x + y * y + z * z);  // of the angle, times both lengths
    const double cosine = p.x * q.x + p.y * q.y + p.z * q.z;
    if (sine > 0) sum += std::atan2(sine, cosine) * z / sine;
  }
  return sum / 2;
}

/// Irradiance at the origin from a parallel disk of radiance 1 (Howell, B-13).
inline double disk_irradiance(double radius, double height, double offset) {
  const double q = height * height + offset * offset - radius * radius;
  const double rest = 4 * radius * radius * height * height;
  const double root = std::sqrt(q * q + rest);
  const double share = q > 0 ? rest / (root * (root + q)) : 1 - q / root;
  return std::numbers::pi / 2 * share;
}

/// The integral of r^-4k over a rectangle at `light.height`.
inline double inverse_powers(const RectLight& light, int k) {
  const double h2 = light.height * light.height;
  return integral_over(light,
                       [&](double x, double y) { return std::pow(x * x + y * y + h2, -2 * k); });
}
/// The same over a disk.
inline double inverse_powers(double radius, double height, double offset, int k) {
  const double h2 = height * height, o2 = offset * offset;
  return 2 * std::numbers::pi * integral(0, radius, height, [&](double r) {
           return r * mean_around(256, [&](double cosine) {
                    return std::pow(r * r + 2 * r * offset * cosine + o2 + h2, -2 * k);
                  });
         });
}

inline double exact(const scenes::RectangleLight& scene) {
  return irradiance(scene.light);
}
inline double moment(const scenes::RectangleLight& scene, int k) {
  const RectLight& light = scene.light;
  const double factor = area(light) * light.radiance * light.height * light.height;
  return std::pow(factor, k) / area(light) * inverse_powers(light, k);
}

inline double exact(const scenes::HorizonLight& s) {
  const double low = std::max(s.z0, 0.0);
  if (s.z1 <= low) return 0;
  const std::array<scenes::Vector, 4> seen{{{s.distance, s.y0, low},
                                            {s.distance, s.y1, low},
                                            {s.distance, s.y1, s.z1},
                                            {s.distance, s.y0, s.z1}}};
  return std::abs(lambert(seen));
}
inline double moment(const scenes::HorizonLight& s, int k) {
  const double size = (s.y1 - s.y0) * (s.z1 - s.z0), d2 = s.distance * s.distance;
  return integral(s.y0, s.y1, s.distance,
                  [&](double y) {
                    return integral(std::max(s.z0, 0.0), s.z1, s.distance, [&](double z) {
                      const double r2 = y * y + z * z + d2;
                      return std::pow(size * z * s.distance / (r2 * r2), k);
                    });
                  }) /
         size;
}

inline double exact(const scenes::DiskLight& s) {
  return disk_irradiance(s.radius, s.height, s.offset);
}
inline double moment(const scenes::DiskLight& s, int k) {
  const double size = std::numbers::pi * s.radius * s.radius;
  return std::pow(size * s.height * s.height, k) / size *
         inverse_powers(s.radius, s.height, s.offset, k);
}

/// The mean of cos^k over the directions of a cone whose axis is tilted by `tilt` from the normal.
/// A polynomial: both quadrature rules are exact for k < 16.
inline double cone_heights(double sine, double tilt, int k) {
  const double cap = 1 - std::sqrt(1 - sine * sine);
  return integral(0, 1, 1, [&](double u) {
    const double z = 1 - cap * u, r = std::sqrt(cap * u * (1 + z));
    return mean_around(16, [&](double cosine) {
      return std::pow(std::cos(tilt) * z + std::sin(tilt) * r * cosine, k);
    });
  });
}

/// A disk of the unit hemisphere, projected onto the ground (Nusselt's analog).
inline double exact(const scenes::SphereLight& s) {
  const double sine = s.radius / s.distance;
  return std::numbers::pi * sine * sine * std::cos(s.tilt);
}
inline double moment(const scenes::SphereLight& s, int k) {
  const double sine = s.radius / s.distance;
  const double solid_angle = 2 * std::numbers::pi * (1 - std::sqrt(1 - sine * sine));
  return std::pow(solid_angle, k) * cone_heights(sine, s.tilt, k);
}

// Shadows -----------------------------------------------------------------------------------------

/// The part of the light that the receiver, at the origin, sees.
inline RectLight seen_light(const scenes::HalfplanePenumbra& s) {
  RectLight seen = s.light;
  seen.x0 -= s.receiver;
  seen.x1 = std::min(s.light.x1 - s.receiver, (s.edge - s.receiver) * s.light.height / s.height);
  seen.x1 = std::max(seen.x0, seen.x1);
  return seen;
}
inline double exact(const scenes::HalfplanePenumbra& scene) {
  return irradiance(seen_light(scene));
}
inline double moment(const scenes::HalfplanePenumbra& scene, int k) {
  const RectLight& light = scene.light;
  const double factor = area(light) * light.radiance * light.height * light.height;
  return std::pow(factor, k) / area(light) * inverse_powers(seen_light(scene), k);
}

/// The part of the light that the occluder hides from the receiver: a larger disk.
inline scenes::DiskLight shadow_of(const scenes::DiskPenumbra& s) {
  const double scale = s.light.height / s.height;
  return {s.radius * scale, s.light.height, std::hypot(s.x, s.y) * scale};
}
inline double exact(const scenes::DiskPenumbra& scene) {
  return irradiance(scene.light) - scene.light.radiance * exact(shadow_of(scene));
}
inline double moment(const scenes::DiskPenumbra& scene, int k) {
  const RectLight& light = scene.light;
  const scenes::DiskLight dark = shadow_of(scene);
  const double factor = area(light) * light.radiance * light.height * light.height;
  return std::pow(factor, k) / area(light) *
         (inverse_powers(light, k) - inverse_powers(dark.radius, dark.height, dark.offset, k));
}

/// Projected onto the ground, half a disk and half an ellipse of the sky remain visible.
inline double exact(const scenes::WallOcclusion& s) {
  return (1 + s.distance / std::hypot(s.distance, s.height)) / 2;
}

inline double exact(const scenes::SphereOcclusion& s) {
  const double sine = s.radius / s.distance;
  return 1 - sine * sine * std::cos(s.tilt);
}

inline double exact(const scenes::SphereOcclusionUniform& s) {
  return exact(s.sphere);
}
/// On the hemisphere the height is uniform; the cone is a fraction `cap` of it.
inline double moment(const scenes::SphereOcclusionUniform& s, int k) {
  const double sine = s.sphere.radius / s.sphere.distance;
  const double cap = 1 - std::sqrt(1 - sine * sine);
  return std::pow(2, k) * (1.0 / (k + 1) - cap * cone_heights(sine, s.sphere.tilt, k));
}

// Edges -------------------------------------------------------------------------------------------

/// The area under a x + b y = c in the unit square: a triangle, minus two corners outside.
inline double exact(const scenes::PixelEdge& s) {
  if (s.c >= s.a + s.b) return 1;
  const auto square = [](double x) { return x > 0 ? x * x : 0; };
  return (square(s.c) - square(s.c - s.a) - square(s.c - s.b)) / (2 * s.a * s.b);
}

/// The fraction of a unit disk where x < t.
inline double disk_below(double t) {
  if (std::abs(t) >= 1) return t > 0 ? 1 : 0;
  return 0.5 + (t * std::sqrt(1 - t * t) + std::asin(t)) / std::numbers::pi;
}
inline double exact(const scenes::DefocusEdge& s) {
  const double circle = s.aperture * std::abs(s.depth - s.focus) / s.focus;
  if (circle == 0) return s.offset > 0 ? 1 : 0;
  return disk_below(s.offset / circle);
}

/// The mean over time of the pixel's white fraction, clamp(s, 0, 1).
inline double exact(const scenes::MotionEdge& s) {
  if (s.speed == 0) return std::clamp(s.start, 0.0, 1.0);
  const auto antiderivative = [](double x) { return x < 0 ? 0 : x < 1 ? x * x / 2 : x - 0.5; };
  return (antiderivative(s.start + s.speed) - antiderivative(s.start)) / s.speed;
}

/// E{max(t - l, 0)^3} for a coordinate l of a uniform point of the unit disk, whose density is 2/pi
/// sqrt(1 - l^2). From the density's moments below t.
inline double cube_across_disk(double t) {
  if (t <= -1) return 0;
  if (t >= 1) return t * t * t + 0.75 * t;  // E{l^2} = 1/4
  const double pi = std::numbers::pi, root = std::sqrt(1 - t * t), cubed = root * root * root;
  const double m0 = disk_below(t);
  const double m1 = -2 / (3 * pi) * cubed;
  const double m2 = 0.125 + (std::asin(t) + t * (2 * t * t - 1) * root) / (4 * pi);
  const double m3 = -2 / (15 * pi) * cubed * (2 + 3 * t * t);
  return t * t * t * m0 - 3 * t * t * m1 + 3 * t * m2 - m3;
}
/// For a given l, the volume under a plane in the cube of x, y, t: a sum of cubes over its corners.
inline double exact(const scenes::PixelTimeLens& s) {
  const std::array<double, 3> edges{s.a, s.b, s.speed};
  double sum = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double left = s.c, sign = 1;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((corner >> axis & 1) == 0) continue;
      left -= edges[axis];
      sign = -sign;
    }
    sum += sign * cube_across_disk(left / s.blur);
  }
  return sum * std::pow(s.blur, 3) / (6 * s.a * s.b * s.speed);
}

/// Stripe n lies where n <= rise / y + phase < n + 1.
inline double exact(const scenes::Stripes& s) {
  double white = 0;
  const double last = std::floor(s.rise / s.top + s.phase);
  for (double n = 2 * std::floor((s.rise / s.bottom + s.phase) / 2); n <= last; n += 2) {
    const double far = std::max(s.top, s.rise / (n + 1 - s.phase));
    const double near = n > s.phase ? std::min(s.bottom, s.rise / (n - s.phase)) : s.bottom;
    if (near > far && n + 1 > s.phase) white += near - far;
  }
  return white / (s.bottom - s.top);
}

// All of them -------------------------------------------------------------------------------------

/// A scene that is 0 or 1: all its moments equal its mean.
template <class S>
concept Indicator = std::same_as<S, scenes::WallOcclusion> ||
    std::same_as<S, scenes::SphereOcclusion> || std::same_as<S, scenes::PixelEdge> ||
    std::same_as<S, scenes::DefocusEdge> || std::same_as<S, scenes::MotionEdge> ||
    std::same_as<S, scenes::PixelTimeLens> || std::same_as<S, scenes::Stripes>;

template <Indicator S>
double moment(const S& scene, int) {
  return exact(scene);
}

/// One sample of a scene.
template <class S>
Population population_of(const S& scene) {
  return population(exact(scene), moment(scene, 2), moment(scene, 3), moment(scene, 4));
}

/// A scene from its fields in order, all of them double; the default scene if there are none.
template <class S>
S scene_with(std::span<const double> parameters) {
  using Fields = std::array<double, sizeof(S) / sizeof(double)>;
  Fields fields = std::bit_cast<Fields>(S{});
  if (!parameters.empty() && parameters.size() != fields.size()) {
    throw std::out_of_range("wrong number of parameters of a scene");
  }
  std::copy(parameters.begin(), parameters.end(), fields.begin());
  return std::bit_cast<S>(fields);
}
template <class S>
std::vector<double> parameters_of(const S& scene) {
  const auto fields = std::bit_cast<std::array<double, sizeof(S) / sizeof(double)>>(scene);
  return {fields.begin(), fields.end()};
}

}  // namespace mc::checks
