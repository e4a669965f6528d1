// 6.7: blue noise where it is seen, in the first next2().

#include "checks/sampler/samplers.hpp"
#include "checks/support/discs.hpp"
#include "checks/support/spectrum.hpp"

namespace mc::checks {
namespace {

CHECK_CASE("6.7 the first next2 is blue noise", "[6.7][main][points:4][needs:4]") {
  Rng rng = check_rng();
  // In the low band best candidates have 0.110 and a standard deviation of 0.020 per set of 64,
  // 0.089 and 0.008 per set of 256, 0.082 and 0.003 per set of 1024: the means are seven deviations
  // below the limits and more. Their radii are 0.636 +- 0.022, 0.666 +- 0.014 and 0.693 +- 0.007:
  // eleven above and more. Of 64 points c = 0.5 has 0.129 +- 0.023 and 0.598: it fails both.
  for (const auto& [n, sets, uses, low, radius] : {std::tuple{256u, 10u, Uses{2}, 0.13, 0.6},
                                                   {256u, 10u, Uses{1, 2}, 0.13, 0.6},
                                                   {1024u, 1u, Uses{1, 1, 2}, 0.13, 0.6},
                                                   {64u, 240u, Uses{2}, 0.119, 0.62}}) {
    const SampleSets got = columns_of("blue_noise", n, domain::seeds(rng, sets), uses);
    double mean_low = 0, mean_radius = 0;  // power over 0 < |k| <= sqrt(N) / 2, relative radius
    for (std::size_t set = 0; set < sets; ++set) {
      const View x = got.column(set, got.dims - 2), y = got.column(set, got.dims - 1);
      mean_low += low_band(spectrum_of(x, y, static_cast<int>(std::sqrt(n) / 2)), n) / sets;
      mean_radius += least_distance(x, y) / std::sqrt(2 / (std::sqrt(3) * n)) / sets;
    }
    const std::string hint =
        uses.size() == 2  // alone it was
            ? "the first next2() is blue noise also where a next() comes before"
            : mean_low > 0.25
                  ? "the first next2() is best_candidate of lab 4, with c = 1; x and y of a "
                    "point stay together"
                  : "as blue as a fixed number of candidates, or too few: with c = 1, point i "
                    "has i + 1 of them";
    expect_that(mean_low < low,
                fmt::format("{}: mean power {:.4f} over 0 < |k| <= sqrt(N)/2", got.call, mean_low),
                fmt::format("less than {}; c = 1 has 0.11 for N = 64, 0.09 for 256", low),
                "independent points have 1, jittered ones 0.33, ten candidates each 0.19", hint);
    expect_that(mean_radius > radius,
                fmt::format("{}: the closest two points of a set are {:.3f} of the densest "
                            "pattern's distance apart, on average",
                            got.call, mean_radius),
                fmt::format("more than {}; c = 1 has 0.64 for N = 64, 0.67 for 256", radius),
                "too few candidates let the last points come close", hint);
  }
}

CHECK_CASE("6.7 each point is uniform over seeds", "[6.7][points:1][needs:4]") {
  Rng rng = check_rng();
  const SampleSets got = columns_of("blue_noise", 16, domain::seeds(rng, 600), {2});
  for (const std::size_t i : {0u, 1u, 8u, 15u}) {
    expect_independent_uniforms(
        sample_of(got, i),
        {.words = "each point is uniform in the square over seeds",
         .alpha = alpha,
         .otherwise = "",
         .explain = [] {
           return "does every pattern begin at the same place? Random as a set, no point is in "
                  "every set; " +
                  same_for_seeds;
         }});
  }
}

CHECK_CASE("6.7 blue noise has exactly N points for any N", "[6.7][points:1][needs:4]") {
  Rng rng = check_rng();
  for (const std::size_t n : domain::sizes(600, rng)) {
    const SampleSets got = columns_of("blue_noise", n, {fresh_seed(rng)}, {2});
    expect_that(least_distance(got.column(0, 0), got.column(0, 1)) > 0,
                got.call + ": two points are at the same place", "N different points",
                "best candidates keep away from each other", "blue noise never has a point twice");
  }
}

CHECK_CASE("6.7 all else of blue_noise is stratified", "[6.7][points:2][needs:6.2][needs:3]") {
  Rng rng = check_rng();
  const Uses uses{2, 1, 2, 1, 2};
  for (const std::size_t n : {509u, 64u, 12u, 3u, 2u, 1u}) {
    const SampleSets got = columns_of("blue_noise", n, {fresh_seed(rng)}, uses);
    for (const std::size_t c : {3u, 6u}) expect_multi_jittered(got, c);
    for (const std::size_t c : {2u, 5u}) {
      expect_one_in_each_cell(got, 0, line_of(n, c), "a next() is stratified_1d, shuffled");
    }
  }
  const SampleSets got = columns_of("blue_noise", 12, domain::seeds(rng, 600), uses);
  for (const std::size_t i : {0u, 7u}) {
    expect_independent_uniforms(sample_of(got, i),
                                {.words = "different columns are independent",
                                 .alpha = alpha,
                                 .otherwise = "each sample dimension needs its own permutation",
                                 .repeated = same_for_seeds});
  }
}

}  // namespace
}  // namespace mc::checks
