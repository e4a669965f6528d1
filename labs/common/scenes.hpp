#pragma once
// The scenes of lab 6: functions that ask a sampler for the coordinates of one sample and return
// its value. `uses` lists their requests in order.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "6-sampler/sampler.hpp"
#include "common/points.hpp"
#include "common/rect_light.hpp"

namespace mc::scenes {

// Mappings from the unit square to the domains that scenes sample. Coordinates are in [0,1).

/// A vector in space; z points away from the surface.
struct Vector {
  double x = 0, y = 0, z = 0;
};

/// A uniform point in the unit disk. The square root makes P(radius < r) = r^2, which is
/// proportional to the area inside radius r.
inline Point2 in_unit_disk(Point2 u) {
  const double r = std::sqrt(u.x), phi = 2 * std::numbers::pi * u.y;
  return {r * std::cos(phi), r * std::sin(phi)};
}

/// The unit vector whose z coordinate is `z`, turned around the z axis by `u` of a full turn.
/// requires: z in [-1,1].
inline Vector direction(double z, double u) {
  const double r = std::sqrt(1 - z * z), phi = 2 * std::numbers::pi * u;
  return {r * std::cos(phi), r * std::sin(phi), z};
}

/// A uniform direction in the hemisphere around z: its z coordinate is uniform (Archimedes).
inline Vector uniform_direction(Point2 u) {
  return direction(u.x, u.y);
}

/// A direction in the hemisphere around z with density cos / pi: a uniform point in the unit disk,
/// projected up to the hemisphere.
/// source: Malley's method: Pharr, Jakob, Humphreys 2023, "Physically based rendering", appendix
///   A.5.3.
inline Vector cosine_direction(Point2 u) {
  return direction(std::sqrt(1 - u.x), u.y);
}

// Scenes, and pictures whose pixels are scenes.

/// The edge of a white half-plane that crosses a pixel. Two dimensions: a point in the pixel.
///
/// White where a x + b y < c; a, b > 0.
struct PixelEdge {
  double a = std::cos(1.0), b = std::sin(1.0), c = 0.1 + (a + b) / 2;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 p = sampler.next2();
    return a * p.x + b * p.y < c ? 1 : 0;
  }
};

/// A picture of an edge that descends gently from left to right. Each pixel is filtered over the 24
/// x 24 pixels around it: otherwise only the few pixels on the edge would show any noise.
inline PixelEdge edge_picture(double width, double height, double column, double row) {
  const double a = 0.31, b = 1, filter = 24;
  const double c = 0.155 * width + 0.5 * height;
  return {filter * a, filter * b,
          c - a * (column - (filter - 1) / 2) - b * (row - (filter - 1) / 2)};
}

/// Stripes on a plane that recedes to the horizon, like a zebra crossing: a pixel near the horizon
/// contains many stripes. One dimension: the vertical position in the pixel.
///
/// A pixel that extends from `top` to `bottom` below the horizon (0 < top < bottom). The plane's
/// depth at y is rise / y. White where floor(depth + phase) is even.
struct Stripes {
  double top = 0.01, bottom = 0.02, rise = 1, phase = 0;

  static constexpr std::string_view uses = "next";

  double operator()(Sampler& sampler) const {
    const double y = top + (bottom - top) * sampler.next();
    return std::fmod(std::floor(rise / y + phase), 2) == 0 ? 1 : 0;
  }
};

/// The plane, starting just below the horizon; the stripes are slightly oblique.
inline Stripes stripes_picture(double width, double height, double column, double row) {
  return {(row + 0.6) / height, (row + 1.6) / height, 4, 3 * (column + 0.5) / width};
}

/// The irradiance from a rectangular light. Two dimensions: a point on the light.
struct RectangleLight {
  RectLight light;

  static constexpr std::string_view uses = "next2";

  /// Area times radiance times both cosines over r^2. Each cosine, at receiver and light, is
  /// height / r.
  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dx = light.x1 - light.x0, dy = light.y1 - light.y0;
    const double x = light.x0 + dx * u.x, y = light.y0 + dy * u.y, h = light.height;
    const double r2 = x * x + y * y + h * h;
    return dx * dy * light.radiance * (h * h) / (r2 * r2);
  }
};

/// The irradiance from a vertical light that extends below the receiver's horizon. Two dimensions:
/// a point on the light.
///
/// The rectangle [y0, y1] x [z0, z1] at x = distance > 0, of radiance 1. It faces the receiver,
/// which is at the origin and faces up (+z).
struct HorizonLight {
  double distance = 1, y0 = -1, y1 = 1, z0 = -0.5, z1 = 1;

  static constexpr std::string_view uses = "next2";

  /// Points below the horizon contribute nothing: the receiver's cosine z / r is negative there.
  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dy = y1 - y0, dz = z1 - z0;
    const double y = y0 + dy * u.x, z = z0 + dz * u.y;
    const double r2 = distance * distance + y * y + z * z;
    return dy * dz * std::max(0.0, z) * distance / (r2 * r2);
  }
};

/// The irradiance from a disk light. Two dimensions: a point on the light.
///
/// A disk of radiance 1, parallel to the receiver. Its center is at `height` > 0 above the
/// receiver's plane, and `offset` to the side.
struct DiskLight {
  double radius = 0.75, height = 1, offset = 0;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 p = in_unit_disk(sampler.next2());
    const double x = offset + radius * p.x, y = radius * p.y, h = height;
    const double r2 = x * x + y * y + h * h;
    return std::numbers::pi * radius * radius * (h * h) / (r2 * r2);
  }
};

/// The irradiance from a spherical light. Two dimensions: a direction toward the light.
///
/// A sphere of radiance 1 whose center is at `distance` > radius from the receiver, at the angle
/// `tilt` from its normal. The whole sphere is above the horizon.
struct SphereLight {
  double radius = 1, distance = 2.5, tilt = 0.6;

  static constexpr std::string_view uses = "next2";

  /// Directions are uniform in the cone that the sphere subtends, so the value of a sample is the
  /// solid angle of the cone times the receiver's cosine.
  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double sine = radius / distance;
    const double cap = sine * sine / (1 + std::sqrt(1 - sine * sine));  // 1 - cos, stably
    const Vector w = direction(1 - cap * u.x, u.y);                     // around the cone's axis
    const double cosine = std::cos(tilt) * w.z - std::sin(tilt) * w.x;
    return 2 * std::numbers::pi * cap * cosine;
  }
};

/// The irradiance in the penumbra of a straight edge. Two dimensions: a point on the light.
///
/// A rectangular light above a receiver at (receiver, 0, 0). An opaque half-plane x > edge at
/// z = height blocks part of the light.
struct HalfplanePenumbra {
  RectLight light;
  double receiver = 0.1, edge = 0.2, height = 0.5;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dx = light.x1 - light.x0, dy = light.y1 - light.y0, h = light.height;
    const double x = light.x0 + dx * u.x - receiver, y = light.y0 + dy * u.y;
    if (receiver + x * height / h > edge) return 0;
    const double r2 = x * x + y * y + h * h;
    return dx * dy * light.radiance * (h * h) / (r2 * r2);
  }
};

/// A floor under the light, half of it in the shadow of a table. A pixel shows the irradiance at
/// its center.
inline HalfplanePenumbra penumbra_picture(double width, double height, double column, double row) {
  const double scale = 3 / width;
  const double y = scale * (row + 0.5 - height / 2);
  HalfplanePenumbra at{{-1, 1, -0.5 - y, 0.5 - y, 1, 1}, scale * (column + 0.5 - width / 2)};
  at.edge = 0.1 + 0.2 * y;  // not parallel to the columns of pixels
  return at;
}

/// The irradiance in the penumbra of a disk. Two dimensions: a point on the light.
///
/// A rectangular light above a receiver at the origin. An opaque disk around (x, y) at z = height,
/// parallel to both, blocks part of the light. Projected from the receiver onto the light's plane,
/// the disk lies entirely inside the light.
struct DiskPenumbra {
  RectLight light;
  double x = 0.15, y = 0.025, radius = 0.15, height = 0.5;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 u = sampler.next2();
    const double dx = light.x1 - light.x0, dy = light.y1 - light.y0, h = light.height;
    const double lx = light.x0 + dx * u.x, ly = light.y0 + dy * u.y;
    const double to_x = lx * height / h - x, to_y = ly * height / h - y;
    if (to_x * to_x + to_y * to_y < radius * radius) return 0;
    const double r2 = lx * lx + ly * ly + h * h;
    return dx * dy * light.radiance * (h * h) / (r2 * r2);
  }
};

/// Ambient occlusion next to a wall: the cosine-weighted fraction of the sky that is visible. Two
/// dimensions: a direction.
///
/// An infinitely long wall at x = distance, from the ground up to `height`.
struct WallOcclusion {
  double distance = 1, height = 0.75;

  static constexpr std::string_view uses = "next2";

  /// Directions have the density cos / pi, so the value of a sample is the visibility, 0 or 1. A
  /// direction with w.x > 0 meets the plane of the wall at z = distance w.z / w.x.
  double operator()(Sampler& sampler) const {
    const Vector w = cosine_direction(sampler.next2());
    return w.x > 0 && distance * w.z < height * w.x ? 0 : 1;
  }
};

/// Ambient occlusion under a sphere, estimated with two densities of directions: the same expected
/// value, but different variances. Two dimensions: a direction.
///
/// A sphere whose center is at `distance` > radius from the receiver, at the angle `tilt` from its
/// normal. The whole sphere is above the horizon. Directions have the density cos / pi.
struct SphereOcclusion {
  double radius = 1, distance = 1.5, tilt = 0;

  static constexpr std::string_view uses = "next2";

  /// Whether the sphere blocks the direction `w`.
  bool hides(const Vector& w) const {
    const double cosine = std::cos(tilt) * w.z + std::sin(tilt) * w.x;
    const double sine = radius / distance;
    return cosine > 0 && cosine * cosine > 1 - sine * sine;
  }

  double operator()(Sampler& sampler) const {
    return hides(cosine_direction(sampler.next2())) ? 0 : 1;
  }
};

/// The same with uniform directions on the hemisphere, each weighted by 2 cos.
struct SphereOcclusionUniform {
  SphereOcclusion sphere;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Vector w = uniform_direction(sampler.next2());
    return sphere.hides(w) ? 0 : 2 * w.z;
  }
};

/// The edge of a white object that is out of focus. Two dimensions: a point on the lens.
///
/// A thin lens of radius `aperture`, focused at the distance `focus`. A point at `depth` is blurred
/// to a circle of confusion of radius aperture |depth - focus| / focus, measured in the plane of
/// the object. The object is a half-plane that ends `offset` to the right of the pixel's center.
struct DefocusEdge {
  double aperture = 0.1, focus = 2, depth = 3, offset = 0.025;

  static constexpr std::string_view uses = "next2";

  double operator()(Sampler& sampler) const {
    const Point2 lens = in_unit_disk(sampler.next2());
    return aperture * (depth - focus) / focus * lens.x < offset ? 1 : 0;
  }
};

/// An edge that recedes: near the camera at the bottom, in focus in between, and far away at the
/// top.
inline DefocusEdge defocus_picture(double width, double height, double column, double row) {
  const double up = (row + 0.5) / height;
  DefocusEdge at;
  at.aperture = 0.35;
  at.depth = 4 - 3.4 * up;
  at.offset = (0.5 + 0.12 * (0.5 - up) - (column + 0.5) / width) * 2;
  return at;
}

/// An edge that moves across a pixel while the shutter is open. Two unrelated dimensions, so two
/// calls of next(): the position in the pixel across the edge, and the time.
///
/// White where x < start + speed t, for x and t in [0,1).
struct MotionEdge {
  double start = 0.2, speed = 1.3;

  static constexpr std::string_view uses = "next next";

  double operator()(Sampler& sampler) const {
    const double x = sampler.next();
    const double t = sampler.next();
    return x < start + speed * t ? 1 : 0;
  }
};

/// Edges that all start at the same column and move faster toward the bottom of the picture.
inline MotionEdge motion_picture(double width, double height, double column, double row) {
  return {0.2 * width + 0.31 - column, 0.6 * width * (row + 0.5) / height};
}

/// Antialiasing, motion blur and defocus in one integral: a pixel is crossed by an edge that moves
/// and is out of focus. Five dimensions: next2 for the pixel, next for the time, next2 for the
/// lens.
///
/// White where a x + b y + speed t + blur l < c, for (x, y) in the pixel, the time t in [0,1),
/// and the lens coordinate l in [-1,1]. a, b, speed, blur > 0.
struct PixelTimeLens {
  double a = std::cos(1.0), b = std::sin(1.0), speed = 0.4, blur = 0.35, c = 0.9;

  static constexpr std::string_view uses = "next2 next next2";

  double operator()(Sampler& sampler) const {
    const Point2 p = sampler.next2();
    const double t = sampler.next();
    const Point2 lens = in_unit_disk(sampler.next2());
    return a * p.x + b * p.y + speed * t + blur * lens.x < c ? 1 : 0;
  }
};

}  // namespace mc::scenes
