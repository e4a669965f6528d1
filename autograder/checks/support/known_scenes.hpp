#pragma once
// The scenes by the names that labs/6-sampler/experiments.hpp gives them, with random parameters.

#include <fmt/format.h>

#include "checks/support/scenes_exact.hpp"
#include "runner/text.hpp"

namespace mc::checks {

// Random parameters -------------------------------------------------------------------------------

// Within the limits of the scenes' comments, and such that the variance is worth measuring: a
// standard deviation of at least 5% of the mean, and a kurtosis below 30.

inline RectLight fresh_light(Rng& rng) {
  return light_in({-1.5, 0}, {-1.5, 0}, {1, 3}, {0.8, 1.5}, rng);
}
inline void draw(scenes::RectangleLight& s, Rng& rng) {
  s.light = fresh_light(rng);
}
inline void draw(scenes::HorizonLight& s, Rng& rng) {
  s.distance = uniform(rng, 0.5, 1.5);
  s.y0 = uniform(rng, -1.5, 0);
  s.y1 = s.y0 + uniform(rng, 1, 2.5);
  s.z0 = uniform(rng, -0.8, -0.2);
  s.z1 = uniform(rng, 0.5, 1.5);
}
inline void draw(scenes::DiskLight& s, Rng& rng) {
  s = {uniform(rng, 0.5, 1.2), uniform(rng, 0.5, 1.2), uniform(rng, 0, 1)};
}
/// The tilt of a sphere that stays above the horizon by a tenth of the available angle.
inline double fresh_tilt(Rng& rng, double radius, double distance, double least) {
  return uniform(rng, least, 0.9 * std::acos(radius / distance));
}
inline void draw(scenes::SphereLight& s, Rng& rng) {
  s.radius = uniform(rng, 0.5, 1.5);
  s.distance = s.radius * uniform(rng, 1.5, 3);
  s.tilt = fresh_tilt(rng, s.radius, s.distance, 0.4);
}
/// The edge's shadow begins somewhere in the middle of the light.
inline void draw(scenes::HalfplanePenumbra& s, Rng& rng) {
  s.light = fresh_light(rng);
  s.receiver = uniform(rng, -0.5, 0.5);
  s.height = s.light.height * uniform(rng, 0.3, 0.7);
  const double x = s.light.x0 + (s.light.x1 - s.light.x0) * uniform(rng, 0.2, 0.8);
  s.edge = s.receiver + (x - s.receiver) * s.height / s.light.height;
}
inline void draw(scenes::DiskPenumbra& s, Rng& rng) {
  s.light = fresh_light(rng);
  const RectLight& light = s.light;
  const double scale = uniform(rng, 0.3, 0.7);  // from the light to the occluder
  const double side = std::min(light.x1 - light.x0, light.y1 - light.y0),
               shadow = side * uniform(rng, 0.15, 0.45);
  s.x = scale * uniform(rng, light.x0 + shadow, light.x1 - shadow);
  s.y = scale * uniform(rng, light.y0 + shadow, light.y1 - shadow);
  s.radius = scale * shadow;
  s.height = scale * light.height;
}
inline void draw(scenes::WallOcclusion& s, Rng& rng) {
  s = {uniform(rng, 0.2, 1), uniform(rng, 0.6, 3)};
}
inline void draw(scenes::SphereOcclusion& s, Rng& rng) {
  s.radius = uniform(rng, 0.5, 1.5);
  s.distance = s.radius * uniform(rng, 1.2, 2);
  s.tilt = fresh_tilt(rng, s.radius, s.distance, 0);
}
inline void draw(scenes::SphereOcclusionUniform& s, Rng& rng) {
  draw(s.sphere, rng);
}
inline void draw(scenes::PixelEdge& s, Rng& rng) {
  s.a = uniform(rng, 0.2, 2);
  s.b = uniform(rng, 0.2, 2);
  s.c = (s.a + s.b) * uniform(rng, 0.25, 0.75);
}
inline void draw(scenes::DefocusEdge& s, Rng& rng) {
  s.aperture = uniform(rng, 0.05, 0.4);
  s.focus = uniform(rng, 1, 3);
  s.depth = s.focus * (uniform(rng) < 0.5 ? uniform(rng, 0.4, 0.8) : uniform(rng, 1.3, 2));
  s.offset = s.aperture * std::abs(s.depth / s.focus - 1) * uniform(rng, -0.7, 0.7);
}
inline void draw(scenes::MotionEdge& s, Rng& rng) {
  s = {uniform(rng, -0.2, 0.4), uniform(rng, 0.6, 1.4)};
}
inline void draw(scenes::PixelTimeLens& s, Rng& rng) {
  s.a = uniform(rng, 0.3, 1);
  s.b = uniform(rng, 0.3, 1);
  s.speed = uniform(rng, 0.2, 0.8);
  s.blur = uniform(rng, 0.2, 0.6);
  s.c = (s.a + s.b + s.speed) / 2 + uniform(rng, -0.3, 0.3);
}
inline void draw(scenes::Stripes& s, Rng& rng) {
  s.top = uniform(rng, 0.01, 0.05);
  s.bottom = s.top * uniform(rng, 1.5, 4);
  s.rise = uniform(rng, 0.1, 0.5);
  s.phase = uniform(rng, 0, 2);
}

// By name -----------------------------------------------------------------------------------------

struct KnownScene {
  std::string_view name;
  std::string_view fields;  ///< the names of its parameters
  Population (*population)(std::span<const double> parameters);
  std::vector<double> (*fresh)(Rng& rng);
};

template <class S>
constexpr KnownScene known_as(std::string_view name, std::string_view fields) {
  return {
      name, fields,
      [](std::span<const double> parameters) { return population_of(scene_with<S>(parameters)); },
      [](Rng& rng) {
        S scene;
        draw(scene, rng);
        return parameters_of(scene);
      }};
}
inline constexpr std::array known_scenes{
    known_as<scenes::PixelEdge>("pixel_edge", "a b c"),
    known_as<scenes::RectangleLight>("rect_light", "x0 x1 y0 y1 height radiance"),
    known_as<scenes::HorizonLight>("rect_light_horizon", "distance y0 y1 z0 z1"),
    known_as<scenes::DiskLight>("disk_light", "radius height offset"),
    known_as<scenes::SphereLight>("sphere_light", "radius distance tilt"),
    known_as<scenes::HalfplanePenumbra>("penumbra_halfplane",
                                        "x0 x1 y0 y1 height radiance receiver edge height"),
    known_as<scenes::DiskPenumbra>("penumbra_disk",
                                   "x0 x1 y0 y1 height radiance x y radius height"),
    known_as<scenes::WallOcclusion>("ao_wall", "distance height"),
    known_as<scenes::SphereOcclusion>("ao_sphere", "radius distance tilt"),
    known_as<scenes::SphereOcclusionUniform>("ao_sphere_uniform", "radius distance tilt"),
    known_as<scenes::DefocusEdge>("defocus_edge", "aperture focus depth offset"),
    known_as<scenes::MotionEdge>("motion_edge", "start speed"),
    known_as<scenes::PixelTimeLens>("pixel_time_lens", "a b speed blur c"),
    known_as<scenes::Stripes>("stripes", "top bottom rise phase"),
};

template <class All>
const auto& named(const All& all, std::string_view name) {
  for (const auto& one : all) {
    if (one.name == name) return one;
  }
  throw std::out_of_range("unknown scene " + std::string(name));
}

/// One sample of a scene with these parameters (none: its defaults).
inline Population scene_population(std::string_view name, std::span<const double> parameters) {
  return named(known_scenes, name).population(parameters);
}

/// The mean of n independent samples of it.
inline Known known_scene(std::string_view name, std::span<const double> parameters, double n = 1) {
  return mean_of(scene_population(name, parameters), n);
}

inline std::vector<double> fresh_parameters(std::string_view name, Rng& rng) {
  return named(known_scenes, name).fresh(rng);
}

/// A scene as reports show it: "stripes with top = 0.05, bottom = 0.1, …".
inline std::string described(std::string_view name, std::span<const double> parameters) {
  std::string words;
  auto value = parameters.begin();
  for (const std::string_view field : text::split(named(known_scenes, name).fields, ' ')) {
    if (value == parameters.end()) break;
    words += fmt::format("{}{} = {:.6g}", words.empty() ? "" : ", ", field, *value++);
  }
  return fmt::format("{} with {}", name, words.empty() ? "default parameters" : words);
}

}  // namespace mc::checks
