#pragma once
// The pictures of lab 6 by their names, pixel by pixel, exactly; and pictures by a submission,
// written for gnuplot with their errors.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "6-sampler/experiments.hpp"
#include "checks/support/known_scenes.hpp"
#include "measurements/support/plot_data.hpp"
#include "protocol/render.hpp"

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

namespace mc::measurements {

// Two pixels of a sheet each are one of these (labs/6-sampler/render.gp).
inline constexpr std::size_t image_width = 128, image_height = 96;

/// Writes a picture of the size of `exact` as `name`.tsv, and its error as `name`-error.tsv.
inline protocol::RenderErrors write_with_error(const std::string& name, const Image& image,
                                               const Values& exact) {
  Values error, distances;
  ErrorSums errors;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    error.push_back(image.pixels[i] - exact[i]);
    errors.add(error[i]);
    if (std::abs(error[i]) > 1e-9) distances.push_back(std::abs(error[i]));
  }
  plot_image(name + ".tsv", image.pixels, image_width);
  plot_image(name + "-error.tsv", error, image_width);
  protocol::RenderErrors result{.rmse = errors.rmse()};
  if (!distances.empty()) {
    const auto at = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 19 / 20);
    std::nth_element(distances.begin(), at, distances.end());
    result.large_error = *at;
  }
  return result;
}

}  // namespace mc::measurements
