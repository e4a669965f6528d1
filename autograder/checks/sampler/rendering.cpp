// 6.5, 6.6: the renderer's loop; pictures.

#include <set>

#include "checks/sampler/samplers.hpp"
#include "checks/support/known_scenes.hpp"

namespace mc::checks {
namespace {

using experiments::SamplerTrace;

/// What integrate() did: a number, one integration, n samples.
template <class Measured>
const SamplerTrace& one_integration(const Measured& got, std::size_t n) {
  return got.exactly({1, 1, 1, n}, any_number);
}

CHECK_CASE("6.5 integrate is the mean over the samples", "[6.5][main][points:3]") {
  Rng rng = check_rng();
  Results results;
  results.is_tame = true;
  for (const std::size_t size : domain::sizes(70000, rng)) {
    const auto n = static_cast<double>(size);
    const double low = size % 2 == 0 ? 1 : -2;
    const double scale = size < 10 ? 1e9 / n : 1;  // large values, whose sum fits into an int
    const Values dealt = uniform_values(rng, size, scale * low, scale * (low + 1));
    const auto got = MEASURE(integrate_recorded, dealt, size, fresh_seed(rng));
    const double sum = std::accumulate(dealt.begin(), dealt.end(), 0.0);
    const auto suspects = [=]() -> std::vector<Suspect> {
      double whole = 0;
      for (const double value : dealt) whole = std::trunc(whole + value);
      return {{sum, "divide by the number of samples"},
              {dealt[0], "advance() moves on to the next sample"},
              {whole / n, "the values were added up in an int, which cuts off the fraction"},
              {sum / (n - 1), "divide by N: this is over N - 1"},
              {(sum - dealt[0]) / n, "the first sample is left out"},
              {(sum - dealt.back()) / n, "the last sample is left out"}};
    };
    results.add(got.call, one_integration(got, size).values[0], sum / n, 2 * n * 0x1p-52 * scale,
                suspects);
  }
  results.expect("the mean of what the scene had for each sample; n roundings of a sum below 2n",
                 "every sample counts once, however large its value is");
}

CHECK_CASE("6.5 integrate walks through the samples once", "[6.5][points:1]") {
  Rng rng = check_rng();
  const std::size_t n = 5 + rng() % 20;
  const auto got = MEASURE(integrate_recorded, uniform_values(rng, n, 0, 1), n, fresh_seed(rng));
  const SamplerTrace& record = one_integration(got, n);
  expect_that(record.generates == 1 && record.samples == Seeds{n},
              fmt::format("{}: {} calls of generate(), the first with {} samples", got.call,
                          record.generates, record.samples[0]),
              fmt::format("one, with {} samples", n), "all samples belong to one point set",
              "generate() once before the loop, advance() at the end of each round");
  expect_that(record.evaluations == n && record.positions == domain::in_a_row(0, n),
              fmt::format("{}: the scene was evaluated {} times, the last time for sample {}",
                          got.call, record.evaluations, record.positions.back()),
              fmt::format("{} times: once for each sample, 0 1 2 …", n),
              "the caller pays for this many samples", "advance() once after each sample");
}

CHECK_CASE("6.5 the seed of integrate decides about the samples", "[6.5][points:1]") {
  Rng rng = check_rng();
  const Seeds given = domain::seeds_by_bit(rng);
  std::set<std::uint64_t> used;
  for (const std::uint64_t seed : given) {
    used.insert(one_integration(MEASURE(integrate_recorded, {1, 2, 3}, 3, seed), 3).seeds[0]);
    if (used.size() == 1 && seed != given[0]) break;
  }
  expect_that(used.size() == given.size(),
              fmt::format("integrate with seed {}, and with seeds that differ from it in one bit: "
                          "generate() was called with {} different seeds",
                          given[0], used.size()),
              fmt::format("{}", given.size()), "the seed decides about the samples",
              used.size() == 1 ? "pass the seed on to generate()"
                               : "seeds have 64 bits: was the seed cut to 32 bits?");
}

CHECK_CASE("6.5 0 samples are refused", "[6.5][edge][points:1]") {
  expect_refused_by_name({{MEASURE_OUTCOME(integrate_recorded, {}, 0, 1), "samples",
                           "a mean of no samples is nothing"}});
}

// No kind may have more than e times the variance of independent samples: that is the most a
// scrambled (0,m,s)-net can have (Owen 1997), and the others have less. Within six standard
// deviations of that: once in 5e8 even for one that had it, and there are 70 of them; those that do
// have less are never near it.

CHECK_CASE("6.5 every kind is unbiased on every scene", "[6.5][points:2][needs:6.3][needs:6.7]") {
  Rng rng = check_rng();
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
      expect_that(
          std::abs(mean - exact) <= 6 * sigma,
          fmt::format("{}, {}: the mean of {} estimates is {}", got.call,
                      described(scene, parameters), replicates, mean),
          fmt::format("{}, give or take {:.3g}", exact, 6 * sigma),
          "six standard deviations of it, if the points were e times worse than "
          "independent ones",
          "does integrate() add every sample unchanged? Is each coordinate uniform in [0, 1)?");
    }
  }
}

/// What render() did: pixels, an integration for each of them, samples.
template <class Measured>
const SamplerTrace& picture_of(const Measured& got, std::size_t pixels, std::size_t spp) {
  const SamplerTrace& record = got.exactly({pixels, pixels, pixels, 2 * pixels * spp});
  expect_that(record.generates == pixels && record.samples == Seeds(pixels, spp),
              fmt::format("{}: {} calls of generate(), the first with {} samples", got.call,
                          record.generates, record.samples.empty() ? 0 : record.samples[0]),
              fmt::format("{}, one for each pixel, with {} samples", pixels, spp),
              "every pixel is a separate integration", "");
  expect_that(record.evaluations == pixels * spp,
              fmt::format("{}: {} evaluations of the scene", got.call, record.evaluations),
              fmt::format("{}: {} for each pixel", pixels * spp, spp),
              "the caller pays for this many samples", "");
  return record;
}

CHECK_CASE("6.6 render puts every pixel in its place", "[6.6][main][points:3][needs:6.5]") {
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
                   .otherwise = "pixel (column, row) has the index row * width + column"};
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
  std::sort(seeds.begin(), seeds.end());
  seeds.erase(std::unique(seeds.begin(), seeds.end()), seeds.end());
  const auto& [width, height, seed] = pictures[0];
  const std::string others = pixels == width * height ? ""
                             : pictures.size() == 2
                                 ? ", then another"
                                 : fmt::format(", then {} others", pictures.size() - 1);
  expect_that(seeds.size() == pixels,
              fmt::format("{} x {} pixels with seed {}{}: {} different seeds for {} pixels", width,
                          height, seed, others, seeds.size(), pixels),
              "all different", claim.because, claim.likely);
}

CHECK_CASE("6.6 no two pixels have the same random numbers", "[6.6][points:3][needs:6.5]") {
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
  std::vector<Picture> by_bit;
  for (const std::uint64_t other : domain::seeds_by_bit(rng)) by_bit.push_back({4, 3, other});
  check_seeds(by_bit, {because, "seeds have 64 bits: was the seed cut to 32 bits?"});
}

CHECK_CASE("6.6 the noise of a picture is white across pixels",
           "[6.6][points:2][needs:6.4][needs:6.5]") {
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

CHECK_CASE("6.6 a picture may have no pixels", "[6.6][edge][points:0.5]") {
  for (const auto& [width, height] : {std::pair{0u, 3u}, {3u, 0u}, {0u, 0u}}) {
    picture_of(MEASURE(render_recorded, width, height, 1, 7), 0, 1);
  }
}

/// Pixels without samples; more pixels than most_samples, whatever their product is in 64 bits.
std::vector<InvalidCall> impossible_pictures() {
  const std::string pixels = "more pixels than most_samples, whatever their product is in 64 bits";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(render_recorded, 2, 2, 0, 1), "spp", "a pixel is a mean of samples"},
      {MEASURE_OUTCOME(render_recorded, 0, 0, 0, 1), "spp", "spp is 0, also where no pixel is"}};
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
