// 6.6: a picture, every pixel an integration of its own.

#include <algorithm>
#include <set>

#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

using experiments::Recorded;

/// What render() did: pixels, an integration for each of them, samples.
template <class Measured>
const Recorded& picture_of(const Measured& got, std::size_t pixels, std::size_t spp) {
  return got.exactly({pixels, pixels, pixels, 2 * pixels * spp});
}

CHECK_CASE("6.6 render puts every pixel in its place", "[6.6][main][points:3]") {
  Rng rng = check_rng();
  const std::size_t width = 3 + rng() % 4, height = 7 + rng() % 4, spp = 2 + rng() % 3;
  const auto got = MEASURE(render_recorded, width, height, spp, fresh_seed(rng));
  const Recorded& record = picture_of(got, width * height, spp);
  const double within = (static_cast<double>(spp) - 1) / 2 / static_cast<double>(spp);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      const double x = static_cast<double>(column), y = static_cast<double>(row);
      expect_within(fmt::format("{}: pixel ({}, {})", got.call, column, row),
                    record.values[row * width + column], x + 10 * y + within, 1e-12,
                    "the mean of the samples of column + 10 row + sample / spp",
                    {{{y + 10 * x + within, "rows and columns have changed places"},
                      {x + 10 * (static_cast<double>(height) - 1 - y) + within,
                       "the first row is the top one"},
                      {x + 10 * y, "only the first sample of each pixel counts"}},
                     "pixel (column, row) stands at row width + column"});
    }
  }
  expect_that(record.evaluations == width * height * spp,
              fmt::format("{}: {} evaluations of the scene", got.call, record.evaluations),
              fmt::format("{}: {} for each pixel", width * height * spp, spp),
              "so many samples were paid for", "");
}

/// The seeds with which each pixel was generated, with `spp` samples each.
Seeds seeds_of_pixels(const std::string& call, const Recorded& record, std::size_t spp) {
  const std::size_t pixels = record.values.size();
  expect_that(record.generates == pixels && record.samples == Seeds(pixels, spp),
              fmt::format("{}: {} calls of generate(), the first with {} samples", call,
                          record.generates, record.samples[0]),
              fmt::format("{}, one for each pixel, with {} samples", pixels, spp),
              "every pixel is an integration of its own", "");
  return record.seeds;
}

CHECK_CASE("6.6 no two pixels have the same random numbers", "[6.6][points:3]") {
  Rng rng = check_rng();
  const std::size_t spp = 2;
  const std::uint64_t seed = fresh_seed(rng);
  const auto seeds_with = [&](std::size_t width, std::size_t height, std::uint64_t given) {
    const auto got = MEASURE(render_recorded, width, height, spp, given);
    return seeds_of_pixels(got.call, picture_of(got, width * height, spp), spp);
  };
  // A small picture, one that is wide and one that is high: seeds may repeat after 64 pixels.
  for (const auto& [width, height] : {std::pair{16u, 12u}, {700u, 3u}, {3u, 700u}}) {
    const std::string call = fmt::format("{} x {} pixels with seed {}", width, height, seed);
    const Seeds seeds = seeds_with(width, height, seed);
    const std::size_t different = std::set(seeds.begin(), seeds.end()).size();
    expect_that(different == seeds.size(),
                fmt::format("{}: {} different seeds for {} pixels", call, different, seeds.size()),
                "a seed for each pixel", "the same pattern in every pixel shows as a pattern",
                "make each pixel's seed from the picture's and from the pixel's own number");
  }
  // Other pictures: the next, one as far away as neighbouring pixels are, one beyond 32 bits.
  const std::size_t width = 16, height = 12, pixels = width * height;
  const Seeds seeds = seeds_with(width, height, seed);
  const auto far = std::uint64_t{1} << 40;
  for (const std::uint64_t step :
       {std::uint64_t{1}, seeds[1] - seeds[0], seeds[width] - seeds[0], far}) {
    std::set all(seeds.begin(), seeds.end());
    for (const std::uint64_t other : seeds_with(width, height, seed + step)) all.insert(other);
    expect_that(all.size() == 2 * pixels,
                fmt::format("{} x {} pixels with seed {}, then with seed {}: {} different seeds "
                            "for {} pixels",
                            width, height, seed, seed + step, all.size(), 2 * pixels),
                "all different", "another picture's noise must not be this one's, moved by a pixel",
                step == far ? "was the seed cut to 32 bits?"
                            : "two pairs of a picture's seed and a pixel meet in one number: their "
                              "sum, say, is the same for (s, p + 1) and (s + 1, p)");
  }
}

CHECK_CASE("6.6 the same seed is the same picture", "[6.6][edge][points:1]") {
  Rng rng = check_rng();
  const std::size_t width = 9, height = 7, spp = 2;
  const std::uint64_t seed = fresh_seed(rng);
  const auto one = MEASURE(render_recorded, width, height, spp, seed);
  const auto again = MEASURE(render_again, width, height, spp, seed, 5, 11);
  const Recorded& first = picture_of(one, width * height, spp);
  const Recorded& last = picture_of(again, width * height, spp);
  expect_that(first.seeds == last.seeds,
              fmt::format("{}: other seeds for generate() than in the first picture that a program "
                          "renders",
                          again.call),
              "the same", "the same seed and size are the same picture, whatever came before",
              "is there anything static, a counter of pixels say, or a clock?");
  expect_that(first.values == last.values, again.call + ": other pixels", "the same",
              "the same seed and size are the same picture, whatever came before",
              "is the image static, and kept from the picture before?");
}

CHECK_CASE("6.6 the noise of a picture is white across pixels", "[6.6][points:1][needs:6.4]") {
  Rng rng = check_rng();
  const std::size_t width = 64, height = 100;  // so that pixels one below the other are tested, too
  for (const std::string& kind : sampler_kinds) {
    const auto got = MEASURE(render_noise, kind, width, height, 1, fresh_seed(rng));
    expect_independent_uniforms(
        {got.call, 1, got.exactly(width * height, unit).pixels},
        {.words = "pixels are independent of each other",
         .alpha = alpha,
         .otherwise = "the numbers of neighbouring pixels have something in common",
         .repeated = "the numbers of pixels come again: a seed for each pixel"});
  }
}

/// A pixel without samples, and more pixels than most_samples, whatever their product is in 64
/// bits.
std::vector<InvalidCall> impossible() {
  const std::string pixels = "more pixels than most_samples, whatever their product is in 64 bits";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(render_recorded, 2, 2, 0, 1), "spp", "a pixel is a mean of samples"}};
  for (const auto& [width, height] :
       {std::pair{1u << 14, 1u << 14}, {1u << 27, 2u}, {2u, (1u << 26) + 1}}) {
    calls.push_back({MEASURE_OUTCOME(render_recorded, width, height, 1, 1), "scene", pixels});
  }
  const std::uint64_t side = std::uint64_t{1} << 32;
  calls.push_back({MEASURE_OUTCOME(render_recorded, side, side, 1, 1), "scene", pixels});
  return calls;
}

CHECK_CASE("6.6 pictures that cannot be are refused", "[6.6][edge][points:1]") {
  expect_refused(impossible());
}

CHECK_CASE("6.6 a refusal names the argument", "[6.6][edge][points:1]") {
  expect_argument_named(impossible());
}

}  // namespace
}  // namespace mc::checks
