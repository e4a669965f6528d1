#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace mc {

class Sampler;  // labs/6-sampler/sampler.hpp

/// An integral over a unit cube, as a renderer sees it: a function that asks a sampler for exactly
/// the coordinates it needs and returns the value of one sample.
struct Scene {
  std::string_view uses;  ///< what a sample asks for, in order: "next2 next next2"
  std::function<double(Sampler&)> sample;
};

/// A picture: a scene for each of width x height pixels. Rows count from the top, from 0.
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
