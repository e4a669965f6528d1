// Mistakes in task 6.6.
#include "sampler.hpp"

#define render right_render
#include "solutions/sampler.cpp"
#undef render

namespace mc {
namespace {

/// The solution's loop, with any seeds for the pixels.
template <class SeedOf>
Image render_with(const PixelScene& scene, Sampler& sampler, std::size_t spp, SeedOf seed_of) {
  if (spp == 0) throw std::invalid_argument("spp: must be positive");
  if (scene.width > 0 && scene.height > most_samples / scene.width) {
    throw std::invalid_argument("scene: more pixels than memory may hold");
  }
  Image image{scene.width, scene.height, {}};
  for (std::size_t row = 0; row < scene.height; ++row) {
    for (std::size_t column = 0; column < scene.width; ++column) {
      const Scene pixel{scene.uses, [&](Sampler& s) { return scene.sample(column, row, s); }};
      image.pixels.push_back(integrate(pixel, sampler, spp, seed_of(column, row)));
    }
  }
  return image;
}

}  // namespace
}  // namespace mc

// mistake: XORs the hashes of the picture's seed and the pixel's index
// hint: occur again for other pairs
namespace mc::xor_of_hashes {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  return render_with(scene, sampler, spp, [=, width = scene.width](auto column, auto row) {
    return mix_bits(seed) ^ mix_bits(row * width + column);
  });
}
}  // namespace mc::xor_of_hashes

// mistake: uses the picture's seed for every pixel
// hint: pixels have the same numbers: use a different seed for each pixel
namespace mc::one_pattern_for_all_pixels {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  return render_with(scene, sampler, spp, [=](std::size_t, std::size_t) { return seed; });
}
}  // namespace mc::one_pattern_for_all_pixels

// mistake: takes the first sample of each pixel instead of the mean
// hint: only the first sample of each pixel was used
namespace mc::one_sample_a_pixel {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  const PixelScene first{scene.width, scene.height, scene.uses,
                         [&, value = 0.0, at = std::size_t{0}](std::size_t column, std::size_t row,
                                                               Sampler& s) mutable {
                           const double here = scene.sample(column, row, s);
                           const std::size_t pixel = 1 + column + scene.width * row;
                           if (at != pixel) value = here;
                           at = pixel;
                           return value;
                         }};
  return right_render(first, sampler, spp, seed);
}
}  // namespace mc::one_sample_a_pixel

// mistake: draws the pixels' seeds from a generator with a seed of 32 bits
// hint: do not truncate the seed to 32 bits
namespace mc::picture_seed_of_32_bits {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  Rng seeds(static_cast<unsigned>(seed));
  return render_with(scene, sampler, spp, [&](std::size_t, std::size_t) { return seeds(); });
}
}  // namespace mc::picture_seed_of_32_bits

// mistake: requests pixel (row, column) from the scene
// hint: rows and columns are swapped
namespace mc::rows_and_columns_swapped {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  PixelScene turned = scene;
  turned.sample = [&](std::size_t column, std::size_t row, Sampler& s) {
    return scene.sample(row, column, s);
  };
  return right_render(turned, sampler, spp, seed);
}
}  // namespace mc::rows_and_columns_swapped

// mistake: seeds a pixel with the picture's seed plus the pixel's index
// hint: occur again for other pairs
namespace mc::seed_plus_pixel {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  return render_with(scene, sampler, spp, [&](std::size_t column, std::size_t row) {
    return seed + row * scene.width + column;
  });
}
}  // namespace mc::seed_plus_pixel

// mistake: seeds a pixel with the picture's seed plus multiples of column and row
// hint: occur again for other pairs
namespace mc::seed_plus_primes {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  return render_with(scene, sampler, spp, [=](std::size_t column, std::size_t row) {
    return seed + 1973 * column + 9277 * row;
  });
}
}  // namespace mc::seed_plus_primes

// mistake: uses only the seven lowest bits of column and row for a pixel's index
// hint: the same noise in every pixel is visible as a pattern
namespace mc::seeds_repeat_after_128_pixels {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  return render_with(scene, sampler, spp, [=](std::size_t column, std::size_t row) {
    return mix_bits(mix_bits(seed) ^ (column % 128 + 128 * (row % 128)));
  });
}
}  // namespace mc::seeds_repeat_after_128_pixels

// mistake: counts the pixels of all pictures that a program renders
// hint: a static or global variable
namespace mc::static_pixel_counter {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  static std::uint64_t pixels = 0;
  return render_with(scene, sampler, spp,
                     [=](std::size_t, std::size_t) { return mix_bits(mix_bits(seed) + ++pixels); });
}
}  // namespace mc::static_pixel_counter

// mistake: multiplies width and height without a limit, and allocates
// hint: render_keyed(1, 16384, 16384, 1, 1) did not end within
// limit: memory
namespace mc::trusts_the_size {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (spp == 0) throw std::invalid_argument("spp: must be positive");
  Image image{scene.width, scene.height, std::vector<double>(scene.width * scene.height)};
  Rng seeds(seed);
  for (std::size_t k = 0; k < image.pixels.size(); ++k) {
    const Scene pixel{
        scene.uses, [&](Sampler& s) { return scene.sample(k % scene.width, k / scene.width, s); }};
    image.pixels[k] = integrate(pixel, sampler, spp, seeds());
  }
  return image;
}
}  // namespace mc::trusts_the_size

// mistake: writes the lowest row first
// hint: the picture is upside down
namespace mc::upside_down {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  PixelScene turned = scene;
  turned.sample = [&](std::size_t column, std::size_t row, Sampler& s) {
    return scene.sample(column, scene.height - 1 - row, s);
  };
  return right_render(turned, sampler, spp, seed);
}
}  // namespace mc::upside_down

// mistake: refuses a picture without pixels
// hint: find the condition that refuses them
namespace mc::wants_pixels {
Image render(const PixelScene& scene, Sampler& sampler, std::size_t spp, std::uint64_t seed) {
  if (scene.width == 0 || scene.height == 0) throw std::invalid_argument("scene: no pixels");
  return right_render(scene, sampler, spp, seed);
}
}  // namespace mc::wants_pixels
