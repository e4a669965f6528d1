// mistake: multiplies width and height, and lets the memory decide
// caught by: 6.6 pictures that cannot be are refused
// hint: render_recorded(16384, 16384, 1, 1) wanted more than
// limit: memory
#include "sampler.hpp"
#define render right_render
#include "solutions/sampler.cpp"
#undef render

namespace mc {

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: no samples for a pixel");
  Image image{scene.width, scene.height, std::vector<double>(scene.width * scene.height)};
  Rng seeds(seed);
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const Scene pixel{
        scene.uses, [&](Sampler& s) { return scene.sample(k % scene.width, k / scene.width, s); }};
    image.pixels[k] = integrate(pixel, sampler, spp, seeds());
  }
  return image;
}

}  // namespace mc
