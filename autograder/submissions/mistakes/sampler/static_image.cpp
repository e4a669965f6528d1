// mistake: adds each picture to the one before it
// caught by: 6.6 the same seed is the same picture
// hint: is the image static
#include "sampler.hpp"
#define render right_render
#include "solutions/sampler.cpp"
#undef render

namespace mc {

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  static Image all;
  const Image image = right_render(scene, sampler, spp, seed);
  const bool is_first = all.pixels.empty();
  if (all.pixels.size() < image.pixels.size()) all.pixels.resize(image.pixels.size());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    all.pixels[i] = is_first ? image.pixels[i] : all.pixels[i] / 2 + image.pixels[i] / 2;
  }
  return {
      image.width,
      image.height,
      {all.pixels.begin(), all.pixels.begin() + static_cast<std::ptrdiff_t>(image.pixels.size())}};
}

}  // namespace mc
