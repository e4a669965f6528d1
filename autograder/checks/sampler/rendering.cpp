// 6.5, 6.6: integration, and rendering of pictures.

#include <set>

#include "6-sampler/keyed.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/known_scenes.hpp"

namespace mc::checks {
namespace {

using experiments::keyed_next;
using experiments::keyed_value;

/// The pixels of a picture of this size.
template <class Measured>
const Values& pixels_of(const Measured& got, std::size_t width, std::size_t height) {
  const Image& image = got.exactly(width * height);
  expect_that(image.width == width && image.height == height,
              fmt::format("{}: an image of {} x {} pixels", got.call, image.width, image.height),
              fmt::format("{} x {}", width, height), "the image is as large as the scene", "");
  return image.pixels;
}

/// A keyed integral, of values from `low` to `high`.
struct KeyedIntegral {
  std::uint64_t key, samples, seed;
  double low, high;
};
/// integrate() gives the mean of keyed values, which depend on the seed, on the number of samples,
/// and on which sample is evaluated when: only the loop over all samples gives it.
void expect_integral(Results& results, const KeyedIntegral& one);
/// The value of evaluation k, if it is of sample i of generate(n, seed).
double value_of(const KeyedIntegral& one, std::uint64_t k, std::uint64_t i, std::uint64_t n,
                std::uint64_t seed);

const std::string in_order =
    "generate(samples, seed) once, then for each sample: evaluate the scene once, add, advance()";

CHECK_CASE("6.5 integrate is the mean over the samples", "[6.5][main][points:4]") {
  Results results;
  results.is_tame = true;
  for (const std::size_t size : domain::sizes(70000, rng)) {
    const double low = size % 2 == 0 ? 1 : -2;
    // Large values whose sum fits into an int.
    const double scale = size < 10 ? 1e9 / static_cast<double>(size) : 1;
    expect_integral(results, {rng(), size, fresh_seed(rng), scale * low, scale * (low + 1)});
  }
  results.expect("the mean of the scene's values; n rounding errors of a sum below 2n", in_order);
}

CHECK_CASE("6.5 every bit of the seed and every sample count", "[6.5][points:1]") {
  Results results;
  KeyedIntegral rare{rng(), 60, fresh_seed(rng), 1, 1};  // a rare event: the first values are equal
  const auto is_rare = [&] {
    for (std::uint64_t k = 0; k < 24; ++k) {
      if (value_of(rare, k, k, rare.samples, rare.seed) != 1) return false;
    }
    return true;
  };
  while (!is_rare()) ++rare.key;
  expect_integral(results, rare);
  for (const std::uint64_t seed : domain::seeds_by_bit(rng)) {
    expect_integral(results, {rng(), 3, seed, 1, 2});
  }
  results.expect("the mean over the samples of generate(samples, seed)",
                 in_order + ", for all samples, whatever their values");
}

// No kind has more than e times the variance of independent samples: that is the bound for a
// scrambled (0,m,s)-net (Owen 1997), and the others have less. Six standard deviations of that are
// exceeded once in 5e8 even if the bound is attained, and there are 70 such means.

CHECK_CASE("6.5 every kind is unbiased on every scene",
           "[6.5][points:2][needs:6.1][needs:6.2][needs:6.3][needs:6.7]") {
  const std::uint64_t n = 16;
  const std::size_t replicates = 200;
  for (const std::string& kind : sampler_kinds) {
    for (const KnownScene& one : known_scenes) {
      const std::string scene(one.name);
      const auto parameters = fresh_parameters(scene, rng);
      const Known known = known_scene(scene, parameters, static_cast<double>(n));
      const double a = uniform(rng, 0.5, 2), b = uniform(rng, -1, 1);
      const auto got =
          MEASURE(estimates, kind, scene, parameters, a, b, n, domain::seeds(rng, replicates));
      double mean = 0;
      for (const double value : got.exactly(replicates)) mean += value / 200;
      const double sigma = a * std::sqrt(std::exp(1) * known.variance / replicates);
      const double exact = a * known.exact + b;
      expect_that(std::abs(mean - exact) <= 6 * sigma,
                  fmt::format("{}, {}: the mean of {} estimates is {}", got.call,
                              described(scene, parameters), replicates, mean),
                  fmt::format("{} ± {:.3g}", exact, 6 * sigma),
                  "six standard deviations, with e times the variance of independent points",
                  "integrate() must add every sample unchanged; coordinates must be uniform");
    }
  }
}

/// Each pixel is the mean of values that depend on its place and on which of spp samples is
/// evaluated when.
CHECK_CASE("6.6 render puts every pixel in its place", "[6.6][main][points:3][needs:6.5]") {
  for (const auto& [width, height, spp] : {std::tuple{3 + rng() % 4, 7 + rng() % 4, 2 + rng() % 3},
                                           {129u, 2u, 1u},
                                           {1u, 65u, 257u},
                                           {1u, 1u, 17u}}) {
    const std::uint64_t key = rng();
    const auto pixel = [=, spp = spp](std::size_t column, std::size_t row, std::uint64_t samples) {
      double sum = 0;
      for (std::uint64_t i = 0; i < samples; ++i) {
        sum += keyed_value(key, column, row, i, keyed_next(key, spp, 0, i));
      }
      return sum / static_cast<double>(samples);
    };
    const auto got = MEASURE(render_keyed, key, width, height, spp, fresh_seed(rng));
    Comparison all{.exact = {},
                   .tolerance = {1e-12},
                   .because = "the mean of the scene's values at this pixel",
                   .suspects = {{{}, "rows and columns are swapped"_likely},
                                {{}, "the picture is upside down"_likely},
                                {{}, "only the first sample of each pixel was used"_likely}},
                   .rule =
                       "pixel (column, row) has the index row * width + column, and is one "
                       "integration with spp samples"};
    for (std::size_t k = 0; k < width * height; ++k) {
      const std::size_t x = k % width, y = k / width;
      all.exact.push_back(pixel(x, y, spp));
      all.suspects[0].values.push_back(pixel(y, x, spp));
      all.suspects[1].values.push_back(pixel(x, height - 1 - y, spp));
      all.suspects[2].values.push_back(pixel(x, y, 1));
    }
    all.name = [&, width = width](std::size_t k) {
      return fmt::format("{}: pixel ({}, {})", got.call, k % width, k / width);
    };
    expect_each({got.call, pixels_of(got, width, height)}, all);
  }
}

struct Picture {
  std::size_t width, height;
  std::uint64_t seed;
};

/// All pixels of these pictures have different seeds.
void check_seeds(const std::vector<Picture>& pictures, const Claim& claim);

CHECK_CASE("6.6 no two pixels have the same random numbers", "[6.6][points:3][needs:6.5]") {
  const std::uint64_t seed = fresh_seed(rng);
  // A small, a wide and a high picture. Of 350,005 32-bit seeds, fourteen occur twice on average.
  for (const auto& [width, height] : {std::pair{16u, 12u}, {70001u, 5u}, {5u, 70001u}}) {
    check_seeds({{width, height, seed}}, {"the same noise in every pixel is visible as a pattern",
                                          "a pixel's seed has 64 bits, from all bits of the "
                                          "picture's seed and of the pixel's index"});
  }
  // Other pictures: the next seed, seeds as far apart as those of neighboring pixels, other bits.
  const std::string
      because = "another picture must not have the same noise, shifted by a pixel",
      hash_both =
          "hash the seed, then that with the index: sums and XORs occur again for other pairs";
  const Seeds here = MEASURE(pixel_seeds, 16, 12, seed).exactly(192, any_number);
  for (const std::uint64_t step : {std::uint64_t{1}, here[1] - here[0], here[16] - here[0]}) {
    check_seeds({{16, 12, seed}, {16, 12, seed + step}}, {because, hash_both});
  }
  std::vector<Picture> by_bit, frames;  // seeds as small as pixel indices
  for (std::uint64_t frame = 0; frame < 40; ++frame) frames.push_back({16, 12, frame});
  check_seeds(frames, {because, hash_both});
  for (const std::uint64_t other : domain::seeds_by_bit(rng)) by_bit.push_back({4, 3, other});
  check_seeds(by_bit, {because,
                       "do not truncate the seed to 32 bits, and do not add to it or multiply it: "
                       "mix all its bits with the pixel's index"});
}

CHECK_CASE("6.6 the noise of a picture is independent across pixels",
           "[6.6][points:2][needs:6.4][needs:6.5]") {
  const std::size_t width = 64, height = 100;  // so that vertical neighbors are tested, too
  for (const std::string& kind : sampler_kinds) {
    const auto got = MEASURE(render_noise, kind, width, height, 1, fresh_seed(rng));
    expect_independent_uniforms(
        {got.call, 1, got.exactly(width * height, unit).pixels},
        {.words = "pixels are independent of each other",
         .rule = "the numbers of neighboring pixels must be independent",
         .repeated = "pixels have the same numbers: use a different seed for each pixel"_likely});
  }
}

CHECK_CASE("6.6 a picture may have no pixels", "[6.6][edge][points:0.5]") {
  for (const auto& [width, height] : {std::pair{0u, 3u}, {3u, 0u}, {0u, 0u}}) {
    pixels_of(MEASURE(render_keyed, 1, width, height, 1, 7), width, height);
  }
}

double value_of(const KeyedIntegral& one, std::uint64_t k, std::uint64_t i, std::uint64_t n,
                std::uint64_t seed) {
  const double v = keyed_value(one.key, 0, 0, k, keyed_next(one.key, n, seed, i));
  return v < 1. / 3 ? 0 : one.low + (one.high - one.low) * v;
}

/// The values if evaluation k is of sample step * k + first of generate(samples + more, seed).
Values values_of(const KeyedIntegral& one, std::uint64_t seed, std::uint64_t step = 1,
                 std::uint64_t first = 0, std::uint64_t more = 0) {
  Values values;
  for (std::uint64_t k = 0; k < one.samples; ++k) {
    values.push_back(value_of(one, k, step * k + first, one.samples + more, seed));
  }
  return values;
}

std::vector<Suspect> suspects_of(const KeyedIntegral& one) {
  const auto n = static_cast<double>(one.samples);
  const Values values = values_of(one, one.seed);
  const double sum = sum_of(values);
  return {{sum, "divide by the number of samples"_likely},
          {sum_of(values_of(one, one.seed, 0)) / n,
           "call advance() after each sample, to move to the next one"_likely},
          {sum_of(values_of(one, one.seed, 1, 1, 1)) / n,
           "call advance() after each sample, not before it"_likely},
          {sum_of(values_of(one, 0)) / n, "pass the seed to generate()"_likely},
          {sum_of(values_of(one, static_cast<std::uint32_t>(one.seed))) / n,
           "do not truncate the seed to 32 bits"_likely},
          {integer_sum(values) / n, "the values were added up in an int, which truncates"_likely},
          {sum / (n - 1), "this divides by N - 1: divide by N"_likely},
          {(sum - values.back()) / n, "the last sample is missing"_likely}};
}

void expect_integral(Results& results, const KeyedIntegral& one) {
  const auto got = MEASURE(integrate_keyed, one.key, one.low, one.high, one.samples, one.seed);
  const auto n = static_cast<double>(one.samples);
  const double scale = std::max(std::abs(one.low), std::abs(one.high));
  results.add(got.call, got.value, sum_of(values_of(one, one.seed)) / n, 2 * n * 0x1p-52 * scale,
              [=] { return suspects_of(one); });
}

void check_seeds(const std::vector<Picture>& pictures, const Claim& claim) {
  Seeds seeds;
  for (const auto& [width, height, seed] : pictures) {
    append(seeds, MEASURE(pixel_seeds, width, height, seed).exactly(width * height, any_number));
  }
  const std::size_t pixels = seeds.size();
  std::ranges::sort(seeds);
  seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
  const auto& [width, height, seed] = pictures[0];
  expect_that(seeds.size() == pixels,
              fmt::format("{} x {} pixels, {} pictures, the first with seed {}: {} different seeds",
                          width, height, pictures.size(), seed, seeds.size()),
              fmt::format("{}, one for each pixel", pixels), claim.because, claim.rule);
}

}  // namespace
}  // namespace mc::checks
