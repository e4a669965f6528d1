// mistake: counts the pixels of all pictures that a program renders
// caught by: 6.6 the same seed is the same picture
// hint: a counter of pixels say
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
  static std::uint64_t pixels = 0;
  Image image{scene.width, scene.height, {}};
  for (std::size_t row = 0; row < scene.height; ++row) {
    for (std::size_t column = 0; column < scene.width; ++column) {
      const Scene pixel{scene.uses, [&](Sampler& s) { return scene.sample(column, row, s); }};
      image.pixels.push_back(integrate(pixel, sampler, spp, mix_bits(mix_bits(seed) + ++pixels)));
    }
  }
  return image;
}

}  // namespace mc
