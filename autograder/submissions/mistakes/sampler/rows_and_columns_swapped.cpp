// mistake: asks the scene for pixel (row, column)
// caught by: 6.6 render puts every pixel in its place
// hint: rows and columns have changed places
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
  Rng seeds(seed);
  for (std::size_t row = 0; row < scene.height; ++row) {
    for (std::size_t column = 0; column < scene.width; ++column) {
      const Scene pixel{scene.uses, [&](Sampler& s) { return scene.sample(row, column, s); }};
      image.pixels.push_back(integrate(pixel, sampler, spp, seeds()));
    }
  }
  return image;
}

}  // namespace mc
