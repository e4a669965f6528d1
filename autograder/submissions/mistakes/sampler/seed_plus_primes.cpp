// mistake: a pixel's seed is the picture's plus multiples of column and row
// caught by: 6.6 no two pixels have the same random numbers
// hint: their sum, say, is the same
#include "sampler.hpp"
#define render right_render
#include "solutions/sampler.cpp"
#undef render

namespace mc {

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: no samples for a pixel");
  if (scene.width > 0 && scene.height > most_samples / scene.width) {
    throw std::invalid_argument("scene: more pixels than memory may hold");
  }
  Image image{scene.width, scene.height, {}};
  for (std::size_t row = 0; row < scene.height; ++row) {
    for (std::size_t column = 0; column < scene.width; ++column) {
      const Scene pixel{scene.uses, [&](Sampler& s) { return scene.sample(column, row, s); }};
      image.pixels.push_back(integrate(pixel, sampler, spp, seed + 1973 * column + 9277 * row));
    }
  }
  return image;
}

}  // namespace mc
