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
double exact_pixel(double width, double height, double column, double row) {
  return exact(at(width, height, column, row));
}
inline constexpr KnownPicture known_pictures[] = {
    {"edge", exact_pixel<scenes::edge_picture>},
    {"penumbra", exact_pixel<scenes::penumbra_picture>},
    {"defocus", exact_pixel<scenes::defocus_picture>},
    {"motion", exact_pixel<scenes::motion_picture>},
    {"stripes", exact_pixel<scenes::stripes_picture>},
};

inline std::vector<double> exact_image(std::string_view picture, unsigned width, unsigned height) {
  const KnownPicture& known = named(known_pictures, picture);
  std::vector<double> pixels;
  for (unsigned row = 0; row < height; ++row) {
    for (unsigned column = 0; column < width; ++column) {
      pixels.push_back(known.pixel(width, height, column, row));
    }
  }
  return pixels;
}

}  // namespace mc::checks

namespace mc::measurements {

// Two pixels of a sheet each are one of these (labs/6-sampler/render.gp).
inline constexpr unsigned image_width = 128, image_height = 96;

/// Writes a picture of the size of `exact` as `name`.tsv, and its error as `name`-error.tsv.
inline protocol::RenderErrors write_with_error(const std::string& name, const Values& pixels,
                                               const Values& exact) {
  Values error, sizes;
  ErrorSums errors;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    error.push_back(pixels[i] - exact[i]);
    errors.add(error[i]);
    if (std::abs(error[i]) > 1e-9) sizes.push_back(std::abs(error[i]));
  }
  plot_image(name + ".tsv", pixels, image_width);
  plot_image(name + "-error.tsv", error, image_width);
  std::sort(sizes.begin(), sizes.end());
  return {.rmse = errors.rmse(), .large_error = sizes.empty() ? 0 : sizes[sizes.size() * 19 / 20]};
}

}  // namespace mc::measurements
