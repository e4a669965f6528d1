// 6.5, 6.6: integration, and rendering of pictures.

#include <set>

#include "checks/sampler/samplers.hpp"
#include "checks/support/known_scenes.hpp"

namespace mc::checks {
namespace {

using experiments::SamplerTrace;

/// The record of integrate(): one integration with n samples.
template <class Measured>
const SamplerTrace& one_integration(const Measured& got, std::size_t n) {
  return got.exactly({1, 1, 1, n}, any_number);
}

CHECK_CASE("6.5 integrate is the mean over the samples", "[6.5][main][points:3]") {
  Results results;
  results.is_tame = true;
  for (const std::size_t size : domain::sizes(70000, rng)) {
    const auto n = static_cast<double>(size);
    const double low = size % 2 == 0 ? 1 : -2;
    const double scale = size < 10 ? 1e9 / n : 1;  // large values whose sum fits into an int
    Values values = uniform_values(rng, size, scale * low, scale * (low + 1));
    const std::size_t zeros = size / 3;
    std::fill_n(values.begin() + 1, zeros, 0.0);
    const auto got = MEASURE(integrate_recorded, values, size, fresh_seed(rng));
    const double sum = sum_of(values);
    const auto suspects = [=]() -> std::vector<Suspect> {
      return {{sum, "divide by the number of samples"},
              {values[0], "call advance() to move to the next sample"},
              {integer_sum(values) / n, "the values were added up in an int, which truncates"},
              {sum / (n - 1), "this divides by N - 1: divide by N"},
              {sum / (n - static_cast<double>(zeros)), "samples of value 0 count, too"},
              {(sum - values[0]) / n, "the first sample is missing"},
              {(sum - values.back()) / n, "the last sample is missing"}};
    };
    results.add(got.call, one_integration(got, size).values[0], sum / n, 2 * n * 0x1p-52 * scale,
                suspects);
  }
  results.expect("the mean of the scene's values; n rounding errors of a sum below 2n",
                 "count every sample once, unchanged: large, small and negative ones");
}

CHECK_CASE("6.5 integrate walks through the samples once", "[6.5][points:1]") {
  const std::size_t n = 5 + rng() % 20;
  const auto got = MEASURE(integrate_recorded, uniform_values(rng, n, 0, 1), n, fresh_seed(rng));
  const SamplerTrace& record = one_integration(got, n);
  expect_that(record.generates == 1 && record.samples == Seeds{n},
              fmt::format("{}: {} calls of generate(), the first with {} samples", got.call,
                          record.generates, record.samples[0]),
              fmt::format("one, with {} samples", n), "the samples are one point set",
              "generate(samples, seed) once before the loop, advance() after each sample");
  expect_that(record.evaluations == n && record.positions == domain::in_a_row(0, n),
              fmt::format("{}: the scene was evaluated {} times, the last time for sample {}",
                          got.call, record.evaluations, record.positions.back()),
              fmt::format("{} times: once for each sample, 0 1 2 …", n),
              "the caller asked for this many samples", "call advance() once after each sample");
}

CHECK_CASE("6.5 the seed of integrate determines the samples", "[6.5][points:1]") {
  const Seeds given = domain::seeds_by_bit(rng);
  std::set<std::uint64_t> used;
  for (const std::uint64_t seed : given) {
    used.insert(one_integration(MEASURE(integrate_recorded, {1, 2, 3}, 3, seed), 3).seeds[0]);
    if (used.size() == 1 && seed != given[0]) break;
  }
  expect_that(
      used.size() == given.size(),
      fmt::format("integrate with seed {} and 64 similar ones: {} different seeds for generate()",
                  given[0], used.size()),
      fmt::format("{}", given.size()), "the seed determines the samples",
      used.size() == 1 ? "pass the seed to generate()" : "do not truncate the seed to 32 bits");
}

CHECK_CASE("6.5 0 samples are refused", "[6.5][edge][points:1]") {
  expect_refused_by_name({{MEASURE_OUTCOME(integrate_recorded, {}, 0, 1), "samples",
                           "there is no mean of 0 samples"}});
}

// No kind has more than e times the variance of independent samples: that is the bound for a
// scrambled (0,m,s)-net (Owen 1997), and the others have less. Six standard deviations of that are
// exceeded once in 5e8 even if the bound is attained, and there are 70 such means.

CHECK_CASE("6.5 every kind is unbiased on every scene", "[6.5][points:2][needs:6.3][needs:6.7]") {
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

/// The record of render(): one integration per pixel.
template <class Measured>
const SamplerTrace& picture_of(const Measured& got, std::size_t pixels, std::size_t spp) {
  const SamplerTrace& record = got.exactly({pixels, pixels, pixels, 2 * pixels * spp});
  expect_that(record.generates == pixels && record.samples == Seeds(pixels, spp),
              fmt::format("{}: {} calls of generate(), the first with {} samples", got.call,
                          record.generates, record.samples.empty() ? 0 : record.samples[0]),
              fmt::format("{}, one for each pixel, with {} samples", pixels, spp),
              "each pixel is a separate integration", "");
  expect_that(record.evaluations == pixels * spp,
              fmt::format("{}: {} evaluations of the scene", got.call, record.evaluations),
              fmt::format("{}: {} for each pixel", pixels * spp, spp),
              "the caller asked for this many samples", "");
  return record;
}

CHECK_CASE("6.6 render puts every pixel in its place", "[6.6][main][points:3][needs:6.5]") {
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
                   .suspects = {{{}, "rows and columns are swapped"},
                                {{}, "the picture is upside down"},
                                {{}, "only the first sample of each pixel was used"}},
                   .rule = "pixel (column, row) has the index row * width + column"};
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
  Seeds seeds;
  for (const auto& [width, height, seed] : pictures) {
    const auto got = MEASURE(render_recorded, width, height, 1, seed);
    const Seeds more = picture_of(got, width * height, 1).seeds;
    seeds.insert(seeds.end(), more.begin(), more.end());
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
  const Seeds here = MEASURE(render_recorded, 16, 12, 1, seed).exactly({192, 192, 192, 384}).seeds;
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

CHECK_CASE("6.6 the noise of a picture is white across pixels",
           "[6.6][points:2][needs:6.4][needs:6.5]") {
  const std::size_t width = 64, height = 100;  // so that vertical neighbors are tested, too
  for (const std::string& kind : sampler_kinds) {
    const auto got = MEASURE(render_noise, kind, width, height, 1, fresh_seed(rng));
    expect_independent_uniforms(
        {got.call, 1, got.exactly(width * height, unit).pixels},
        {.words = "pixels are independent of each other",
         .rule = "the numbers of neighboring pixels must be independent",
         .repeated = "pixels have the same numbers: use a different seed for each pixel"});
  }
}

CHECK_CASE("6.6 a picture may have no pixels", "[6.6][edge][points:0.5]") {
  for (const auto& [width, height] : {std::pair{0u, 3u}, {3u, 0u}, {0u, 0u}}) {
    picture_of(MEASURE(render_recorded, width, height, 1, 7), 0, 1);
  }
}

/// Pixels without samples; more pixels than most_samples, even if the product overflows.
std::vector<InvalidCall> impossible_pictures() {
  const std::string pixels = "more pixels than most_samples, even if width * height overflows";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(render_recorded, 2, 2, 0, 1), "spp", "a pixel is a mean of samples"},
      {MEASURE_OUTCOME(render_recorded, 0, 0, 0, 1), "spp",
       "spp must not be 0, even without pixels"}};
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

REFUSAL_CASES("6.6", "impossible pictures are refused", "0.5", "a refusal names the argument", "1",
              impossible_pictures())

}  // namespace
}  // namespace mc::checks
