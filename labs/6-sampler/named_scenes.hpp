#pragma once
// The scenes and pictures of labs/common/scenes.hpp, by name.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "common/scenes.hpp"

namespace mc::experiments {

/// The scene S with the given fields, all of them double, or with its defaults if none are given.
template <class S>
Scene scene_with(std::span<const double> parameters) {
  std::array<double, sizeof(S) / sizeof(double)> fields = std::bit_cast<decltype(fields)>(S{});
  if (!parameters.empty() && parameters.size() != fields.size()) {
    throw std::out_of_range("parameters: the scene takes " + std::to_string(fields.size()));
  }
  std::ranges::copy(parameters, fields.begin());
  return {S::uses, std::bit_cast<S>(fields)};
}

struct NamedScene {
  std::string_view name;
  Scene (*with)(std::span<const double> parameters);
};
inline constexpr NamedScene scenes[] = {
    {"pixel_edge", scene_with<scenes::PixelEdge>},
    {"rect_light", scene_with<scenes::RectangleLight>},
    {"rect_light_horizon", scene_with<scenes::HorizonLight>},
    {"disk_light", scene_with<scenes::DiskLight>},
    {"sphere_light", scene_with<scenes::SphereLight>},
    {"penumbra_halfplane", scene_with<scenes::HalfplanePenumbra>},
    {"penumbra_disk", scene_with<scenes::DiskPenumbra>},
    {"ao_wall", scene_with<scenes::WallOcclusion>},
    {"ao_sphere", scene_with<scenes::SphereOcclusion>},
    {"ao_sphere_uniform", scene_with<scenes::SphereOcclusionUniform>},
    {"defocus_edge", scene_with<scenes::DefocusEdge>},
    {"motion_edge", scene_with<scenes::MotionEdge>},
    {"pixel_time_lens", scene_with<scenes::PixelTimeLens>},
    {"stripes", scene_with<scenes::Stripes>},
};

/// A picture with one scene per pixel: `at` gives the scene's parameters for a pixel.
template <auto at>
PixelScene picture_of(std::size_t width, std::size_t height) {
  using S = decltype(at(0, 0, 0, 0));
  return {width, height, S::uses, [=](std::size_t column, std::size_t row, Sampler& sampler) {
            return at(static_cast<double>(width), static_cast<double>(height),
                      static_cast<double>(column), static_cast<double>(row))(sampler);
          }};
}

struct NamedPicture {
  std::string_view name;
  PixelScene (*sized)(std::size_t width, std::size_t height);
};
inline constexpr NamedPicture pictures[] = {
    {"edge", picture_of<scenes::edge_picture>},
    {"penumbra", picture_of<scenes::penumbra_picture>},
    {"defocus", picture_of<scenes::defocus_picture>},
    {"motion", picture_of<scenes::motion_picture>},
    {"stripes", picture_of<scenes::stripes_picture>},
};

/// The entry with this name.
/// throws: std::out_of_range if there is none; the message lists the names.
template <class Named, std::size_t size>
const Named& named(const Named (&all)[size], const std::string& name) {
  std::string names;
  for (const Named& one : all) {
    if (one.name == name) return one;
    names += ' ' + std::string(one.name);
  }
  throw std::out_of_range("'" + name + "' is unknown; known names:" + names);
}

}  // namespace mc::experiments
