// 6.2: every sample dimension stratified, in an order of its own.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "checks/sampler/planes.hpp"
#include "checks/sampler/relations.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/known_scenes.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

// Of 40,009 numbers kept as floats 16 leave their stratum, on average; of 10,007 but one does.
constexpr std::size_t sizes[] = {64, 12, 1009, 7, 40009, 3, 2, 1};

CHECK_CASE("6.2 next has one number in each of N strata", "[6.2][points:4][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : sizes) {
    const Columns got = columns_of("stratified", n, {fresh_seed(rng)}, {1, 1, 1});
    for (std::size_t c = 0; c < got.dims; ++c) {
      expect_one_in_each(got.call, fmt::format("next() {}", c).c_str(), got[c], n,
                         "a next() is stratified_1d, shuffled");
    }
  }
}

CHECK_CASE("6.2 next2 has one point in each cell and stratum", "[6.2][main][points:5][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : sizes) {
    const Columns got = columns_of("stratified", n, {fresh_seed(rng)}, {2, 2});
    for (std::size_t c = 0; c < got.dims; c += 2)
      expect_multi_jittered(got.call, got[c], got[c + 1]);
  }
}

CHECK_CASE("6.2 each sample dimension has a permutation of its own", "[6.2][points:5][needs:3]") {
  Rng rng = check_rng();
  const std::size_t n = 10007;
  const Columns got = columns_of("stratified", n, {fresh_seed(rng)}, repeated(6, {1, 2}));
  const auto use_of = [](std::size_t c) { return c / 3 * 2 + (c % 3 > 0 ? 1 : 0); };
  Values index(n);
  std::iota(index.begin(), index.end(), 0.0);
  for (std::size_t c = 0; c < got.dims; ++c) {
    expect_unrelated(got.call, index, got[c],
                     fmt::format("the numbers of the samples and coordinate {}", c),
                     "the strata come in order: the pattern must be shuffled");
    for (std::size_t other = 0; other < c; ++other) {
      if (use_of(other) == use_of(c)) continue;
      expect_unrelated(
          got.call, got[other], got[c], fmt::format("coordinates {} and {}", other, c),
          "one permutation for different sample dimensions: each needs a shuffle of its own");
    }
  }
  pass();
  // Where a point lies within its stratum: uniform, and of its own for every sample dimension.
  const auto jitter = [&](std::size_t c) {
    Values jitters;
    for (const double x : got[c]) {
      const double scaled = x * static_cast<double>(n);
      jitters.push_back(std::clamp(scaled - std::floor(scaled), 0.0, 1 - 0x1p-53));
    }
    return jitters;
  };
  const std::string hint = "points are uniform in their strata: a number for each";
  for (const std::size_t c : {0u, 1u}) {
    expect_uniform(fmt::format("{}, places within the strata of coordinate {}", got.call, c),
                   jitter(c), "points are uniform in their strata", hint);
  }
  expect_uniform_pairs(got.call + ", pairs of places within the strata of coordinates 0 and 3",
                       jitter(0), jitter(3),
                       "the jitter of different sample dimensions is independent", hint);
  // Which stratum the first sample is in.
  const Columns firsts = columns_of("stratified", 5, neighbours(fresh_seed(rng), 600), {1, 2});
  for (std::size_t c = 0; c < 3; ++c) {
    const char* const which[] = {"next()", "x of next2()", "y of next2()"};
    const Values x = firsts.first(c);
    expect_uniform(
        fmt::format("{}: {} of the first sample", firsts.call, which[c]), x,
        "the first sample is uniform over seeds",
        std::set(x.begin(), x.end()).size() == 1
            ? same_for_seeds
            : "the first sample may lie anywhere: the shuffle's numbers come from the seed");
  }
}

/// What n strata of the line leave of the variance of a pixel of stripes: of the mean, and its
/// fourth moment over that squared.
struct Left {
  double variance, kurtosis;
};

Left left_of_stripes(const scenes::Stripes& pixel, std::size_t n) {
  const auto size = static_cast<double>(n);
  double variance = 0, fourth = 0;  // of the sum: cumulants of Bernoulli variables add up
  for (std::size_t i = 0; i < n; ++i) {
    scenes::Stripes part = pixel;
    const double height = pixel.bottom - pixel.top;
    part.top = pixel.top + height * (static_cast<double>(i) / size);
    part.bottom = pixel.top + height * (static_cast<double>(i + 1) / size);
    const double p = exact(part), pq = p * (1 - p);
    variance += pq;
    fourth += pq * (1 - 6 * pq);
  }
  return {variance / (size * size), 3 + fourth / (variance * variance)};
}

CHECK_CASE("6.2 the error is that of stratified samples", "[6.2][points:4][needs:6.5][needs:3]") {
  Rng rng = check_rng();
  // A dozen stripes in the pixel: with 64 strata and more, one edge in a few of them.
  scenes::Stripes pixel;
  pixel.top = uniform(rng, 0.04, 0.05);
  pixel.bottom = 2 * pixel.top;
  pixel.rise = 12 * pixel.bottom;
  pixel.phase = uniform(rng);
  const Values parameters{pixel.top, pixel.bottom, pixel.rise, pixel.phase};
  const double mean = exact(pixel);
  const std::size_t seeds = 600;
  std::vector<Replicates> estimates;
  std::vector<Values> values(2);
  std::vector<Known> known;
  for (const std::size_t n : {64u, 512u}) {
    const Left left = left_of_stripes(pixel, n);
    const auto got =
        MEASURE(estimates, "stratified", "stripes", parameters, 1, 0, n, fresh_seeds(rng, seeds));
    Values& here = values[estimates.size()] = got.exactly(seeds);
    estimates.push_back({fmt::format("{}, {}", got.call, described("stripes", parameters)), here,
                         static_cast<double>(n)});
    known.push_back({mean, left.variance, left.kurtosis});
    const Hints hints{{{mean * (1 - mean) / static_cast<double>(n) / left.variance,
                        "these are independent samples: no strata"}},
                      "one number in each of the N strata, uniform in it"};
    expect_mean(estimates.back(), mean, left.variance,
                {"the estimates have the pixel's exact mean", alpha}, hints);
    expect_variance(estimates.back(), mean, left.variance, left.kurtosis,
                    {"what is left is the variance within the strata", alpha}, hints);
  }
  expect_rate(estimates[0], known[0], estimates[1], known[1],
              {"the error of stripes falls as the strata that an edge crosses", alpha},
              {{{0.5, "the error falls as that of independent samples"}}, ""});
}

}  // namespace
}  // namespace mc::checks
