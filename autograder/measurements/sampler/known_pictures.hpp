#pragma once
// The pictures of lab 6 by their names, pixel by pixel, exactly.

#include "checks/support/known_scenes.hpp"

namespace mc::checks {

/// A picture's pixels, exactly: each is a scene with other parameters.
struct KnownPicture {
  std::string_view name;
  double (*pixel)(double width, double height, double column, double row);
};
template <auto at>
constexpr KnownPicture picture_as(std::string_view name) {
  return {name, [](double width, double height, double column, double row) {
            return exact(at(width, height, column, row));
          }};
}
inline constexpr std::array known_pictures{
    picture_as<scenes::edge_picture>("edge"),
    picture_as<scenes::penumbra_picture>("penumbra"),
    picture_as<scenes::defocus_picture>("defocus"),
    picture_as<scenes::motion_picture>("motion"),
    picture_as<scenes::stripes_picture>("stripes"),
};

inline std::vector<double> exact_image(std::string_view picture, std::size_t width,
                                       std::size_t height) {
  const KnownPicture& known = named(known_pictures, picture);
  std::vector<double> pixels;
  for (std::size_t i = 0; i < width * height; ++i) {
    pixels.push_back(known.pixel(static_cast<double>(width), static_cast<double>(height),
                                 static_cast<double>(i % width), static_cast<double>(i / width)));
  }
  return pixels;
}

}  // namespace mc::checks
