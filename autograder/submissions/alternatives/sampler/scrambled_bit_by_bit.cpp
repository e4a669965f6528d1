// alternative: Sobol' points scrambled by the definition, 53 bits one after the other; blue noise
// whose points have each been moved once to where there is more room; a pixel's seed is a mix of
// the picture's and of mixed coordinates

#include <algorithm>
#include <cmath>

#include "sampler.hpp"

namespace mc {
namespace {

void scramble_bit_by_bit(std::span<double> column, std::uint64_t seed) {
  for (double& x : column) {
    const auto word = static_cast<std::uint64_t>(std::ldexp(x, 53));
    std::uint64_t scrambled = 0, before = 1;  // the bits that stand before, behind a 1
    for (int bit = 52; bit >= 0; --bit) {
      const std::uint64_t here = word >> bit & 1;
      const std::uint64_t flip = mix_bits(mix_bits(seed) ^ mix_bits(before)) >> 63;
      scrambled = 2 * scrambled + (here ^ flip);
      before = 2 * before + here;
    }
    x = std::ldexp(static_cast<double>(scrambled), -53);
  }
}

/// Best candidates, each of which may move to the best of fifty new places.
void with_more_room(std::span<double> x, std::span<double> y, double c, Rng& rng) {
  best_candidate(x, y, c, rng);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const auto room = [&](Point2 p) {
      double nearest = 1;
      for (std::size_t j = 0; j < x.size(); ++j) {
        if (j != i) nearest = std::min(nearest, toroidal_distance_squared(p, {x[j], y[j]}));
      }
      return nearest;
    };
    double most = room({x[i], y[i]});
    for (int place = 0; place < 50; ++place) {
      const Point2 p{to_unit(rng()), to_unit(rng())};
      const double here = room(p);
      if (here <= most) continue;
      most = here;
      x[i] = p.x;
      y[i] = p.y;
    }
  }
}

}  // namespace
}  // namespace mc

#define owen_scramble scramble_bit_by_bit
#define best_candidate with_more_room
#define render right_render
#include "solutions/sampler.cpp"
#undef owen_scramble
#undef best_candidate
#undef render

namespace mc {

Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: one sample at least");
  if (scene.width > 0 && scene.height > most_samples / scene.width) {
    throw std::invalid_argument("scene: too many pixels");
  }
  Image image{scene.width, scene.height, std::vector<double>(scene.width * scene.height)};
  for (std::size_t column = scene.width; column-- > 0;) {  // in another order, too
    for (std::size_t row = scene.height; row-- > 0;) {
      const Scene pixel{scene.uses, [&](Sampler& s) { return scene.sample(column, row, s); }};
      const std::uint64_t at = mix_bits(column + mix_bits(row + 1));
      image.pixels[row * scene.width + column] =
          integrate(pixel, sampler, spp, mix_bits(seed ^ at));
    }
  }
  return image;
}

}  // namespace mc
