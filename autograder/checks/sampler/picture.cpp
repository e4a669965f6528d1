// 6.6: a picture, every pixel an integration of its own.

#include <set>

#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/compare.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

using experiments::Recorded;

/// What render() did: pixels, an integration for each of them, samples.
template <class Measured>
const Recorded& picture_of(const Measured& got, std::size_t pixels, std::size_t spp) {
  const Recorded& record = got.exactly({pixels, pixels, pixels, 2 * pixels * spp});
  expect_that(record.generates == pixels && record.samples == Seeds(pixels, spp),
              fmt::format("{}: {} calls of generate(), the first with {} samples", got.call,
                          record.generates, record.samples[0]),
              fmt::format("{}, one for each pixel, with {} samples", pixels, spp),
              "every pixel is an integration of its own", "");
  expect_that(record.evaluations == pixels * spp,
              fmt::format("{}: {} evaluations of the scene", got.call, record.evaluations),
              fmt::format("{}: {} for each pixel", pixels * spp, spp),
              "so many samples were paid for", "");
  return record;
}

CHECK_CASE("6.6 render puts every pixel in its place", "[6.6][main][points:3]") {
  Rng rng = check_rng();
  for (const auto& [width, height, spp] : {std::tuple{3 + rng() % 4, 7 + rng() % 4, 2 + rng() % 3},
                                           {129u, 2u, 1u},
                                           {1u, 65u, 257u},
                                           {1u, 1u, 17u}}) {
    const auto got = MEASURE(render_recorded, width, height, spp, fresh_seed(rng));
    const std::size_t pixels = width * height;
    const double within = (static_cast<double>(spp) - 1) / 2 / static_cast<double>(spp);
    Comparison all{.exact = {},
                   .tolerance = {1e-12},
                   .because = "the mean of the samples of column + 10 row + sample / spp",
                   .suspects = {{{}, "rows and columns have changed places"},
                                {{}, "the first row is the top one"},
                                {{}, "only the first sample of each pixel counts"}},
                   .otherwise = "pixel (column, row) stands at row width + column"};
    for (std::size_t k = 0; k < pixels; ++k) {
      const auto x = static_cast<double>(k % width), y = static_cast<double>(k / width);
      all.exact.push_back(x + 10 * y + within);
      all.suspects[0].values.push_back(y + 10 * x + within);
      all.suspects[1].values.push_back(x + 10 * (static_cast<double>(height) - 1 - y) + within);
      all.suspects[2].values.push_back(x + 10 * y);
    }
    all.name = [&, width = width](std::size_t k) {
      return fmt::format("{}: pixel ({}, {})", got.call, k % width, k / width);
    };
    expect_each({got.call, picture_of(got, pixels, spp).values}, all);
  }
}

struct Picture {
  std::size_t width, height;
  std::uint64_t seed;
};

/// All pixels of these pictures have different seeds.
void check_seeds(const std::vector<Picture>& pictures, const Claim& claim) {
  std::set<std::uint64_t> seeds;
  std::size_t pixels = 0;
  for (const auto& [width, height, seed] : pictures) {
    const auto got = MEASURE(render_recorded, width, height, 1, seed);
    for (const std::uint64_t of_pixel : picture_of(got, width * height, 1).seeds) {
      seeds.insert(of_pixel);
    }
    pixels += width * height;
  }
  const auto& [width, height, seed] = pictures[0];
  const std::string last = pictures.size() == 1
                               ? std::string()
                               : fmt::format(", then with seed {}", pictures.back().seed);
  expect_that(seeds.size() == pixels,
              fmt::format("{} x {} pixels with seed {}{}: {} different seeds for {} pixels", width,
                          height, seed, last, seeds.size(), pixels),
              "all different", claim.because, claim.likely);
}

CHECK_CASE("6.6 no two pixels have the same random numbers", "[6.6][points:3]") {
  Rng rng = check_rng();
  const std::uint64_t seed = fresh_seed(rng);
  // A small picture, one that is wide and one that is high. Of 350,005 seeds of 32 bits fourteen
  // come twice, on average.
  for (const auto& [width, height] : {std::pair{16u, 12u}, {70001u, 5u}, {5u, 70001u}}) {
    check_seeds({{width, height, seed}},
                {"the same pattern in every pixel shows as a pattern",
                 "make each pixel's seed from the picture's and from the pixel's own number"});
  }
  // Other pictures: the next, one as far away as neighboring pixels are, one for each bit.
  const std::string because = "another picture's noise must not be this one's, moved by a pixel";
  const Seeds here = MEASURE(render_recorded, 16, 12, 1, seed).exactly({192, 192, 192, 384}).seeds;
  for (const std::uint64_t step : {std::uint64_t{1}, here[1] - here[0], here[16] - here[0]}) {
    check_seeds({{16, 12, seed}, {16, 12, seed + step}},
                {because,
                 "two pairs of a picture's seed and a pixel meet in one number: their "
                 "sum, say, is the same for (s, p + 1) and (s + 1, p)"});
  }
  const Seeds by_bit = domain::seeds_by_bit(rng);
  for (const std::uint64_t other : by_bit) {
    if (other == by_bit[0]) continue;
    check_seeds({{4, 3, by_bit[0]}, {4, 3, other}},
                {because, "seeds have 64 bits: was the seed cut to 32 bits?"});
  }
}

CHECK_CASE("6.6 the noise of a picture is white across pixels", "[6.6][points:2][needs:6.4]") {
  Rng rng = check_rng();
  const std::size_t width = 64, height = 100;  // so that pixels one below the other are tested, too
  for (const std::string& kind : sampler_kinds) {
    const auto got = MEASURE(render_noise, kind, width, height, 1, fresh_seed(rng));
    expect_independent_uniforms(
        {got.call, 1, got.exactly(width * height, unit).pixels},
        {.words = "pixels are independent of each other",
         .alpha = alpha,
         .otherwise = "the numbers of neighboring pixels have something in common",
         .repeated = "the numbers of pixels come again: a seed for each pixel"});
  }
}

/// A pixel without samples, and more pixels than most_samples, whatever their product is in 64
/// bits.
std::vector<InvalidCall> impossible_pictures() {
  const std::string pixels = "more pixels than most_samples, whatever their product is in 64 bits";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(render_recorded, 2, 2, 0, 1), "spp", "a pixel is a mean of samples"}};
  const std::uint64_t side = std::uint64_t{1} << 32;
  for (const auto& [width, height] : {std::pair{side >> 18, side >> 18},
                                      {side >> 5, std::uint64_t{2}},
                                      {std::uint64_t{2}, (side >> 6) + 1},
                                      {side, side},
                                      {2 * side, side / 2 + 1}}) {
    calls.push_back({MEASURE_OUTCOME(render_recorded, width, height, 1, 1), "scene", pixels});
  }
  return calls;
}

CHECK_CASE("6.6 pictures that cannot be are refused", "[6.6][edge][points:1]") {
  expect_refused(impossible_pictures());
}

CHECK_CASE("6.6 a refusal names the argument", "[6.6][edge][points:1]") {
  expect_argument_named(impossible_pictures());
}

}  // namespace
}  // namespace mc::checks
