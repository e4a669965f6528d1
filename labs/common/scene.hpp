#pragma once

#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

namespace mc {

class Sampler;  // labs/6-sampler/sampler.hpp

/// An integral over a unit cube, as a renderer sees it: something that turns random numbers into a
/// sample. It asks a sampler for exactly the numbers it needs, and for nothing more.
struct Scene {
  std::string_view uses;  ///< what one sample asks for, in order: "next2 next next2"
  std::function<double(Sampler&)> sample;
};

/// A picture: a scene of its own for each of width x height pixels, row by row from the top.
struct PixelScene {
  std::size_t width = 0, height = 0;
  std::string_view uses;
  std::function<double(std::size_t column, std::size_t row, Sampler&)> sample;
};

/// What comes of it: pixels row by row, from the top.
struct Image {
  std::size_t width = 0, height = 0;
  std::vector<double> pixels;
};

}  // namespace mc
