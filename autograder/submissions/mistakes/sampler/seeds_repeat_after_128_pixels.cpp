// mistake: takes the seven lowest bits of column and row for a pixel's number
// caught by: 6.6 no two pixels have the same random numbers
// hint: the same pattern in every pixel shows as a pattern
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
      image.pixels.push_back(integrate(
          pixel, sampler, spp, mix_bits(mix_bits(seed) ^ (column % 128 + 128 * (row % 128)))));
    }
  }
  return image;
}

}  // namespace mc
