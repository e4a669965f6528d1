#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace mc {

class Sampler;  // labs/6-sampler/sampler.hpp

/// An integral over the unit cube, as a renderer sees it: a function that requests exactly the
/// coordinates it needs from a sampler and returns the value of one sample.
struct Scene {
  std::string_view uses;  ///< the calls of each sample, in order: "next2 next next2"
  std::function<double(Sampler&)> sample;
};

/// A picture: one scene for each of width x height pixels. Row 0 is at the top.
struct PixelScene {
  std::size_t width = 0, height = 0;
  std::string_view uses;
  std::function<double(std::size_t column, std::size_t row, Sampler&)> sample;
};

/// A rendered picture: one value for each pixel, row by row from the top.
struct Image {
  std::size_t width = 0, height = 0;
  std::vector<double> pixels;
};

}  // namespace mc
