// 6.7: blue noise in the first next2().

#include <set>

#include "checks/sampler/samplers.hpp"
#include "checks/support/disks.hpp"
#include "checks/support/spectrum.hpp"

namespace mc::checks {
namespace {

/// The low band of c = 1 is six standard errors or more below `low`, for N = 55 to 80, 200
/// to 300, and above 1,024, where one pattern takes as long as a plain loop over all points may.
/// The median relative radius is below `radius` less than once in 10^8 runs; in a single set the
/// first points may be close by chance.
struct BlueSets {
  std::size_t n, sets;
  Uses uses;
  double low, radius;
};
std::vector<BlueSets> blue_sets(Rng& rng);

CHECK_CASE("6.7 the first next2 is blue noise", "[6.7][main][points:5][needs:4]") {
  for (const auto& [n, sets, uses, low, radius] : blue_sets(rng)) {
    const SampleSets got = columns_of("blue_noise", n, domain::seeds(rng, sets), uses);
    double mean_low = 0;  // power over 0 < |k| <= sqrt(N) / 2
    Values radii;
    for (std::size_t set = 0; set < sets; ++set) {
      const View x = got.column(set, got.dims - 2), y = got.column(set, got.dims - 1);
      mean_low +=
          low_band(spectrum_of(x, y, static_cast<int>(std::sqrt(n) / 2)), static_cast<double>(n)) /
          static_cast<double>(sets);
      radii.push_back(least_distance(x, y) /
                      std::sqrt(2 / (std::sqrt(3) * static_cast<double>(n))));
    }
    std::ranges::sort(radii);
    const std::string rule =
        "the first next2(), also after a next(), must be lab 4's best_candidate() with c = 1: "
        "point "
        "i is the best of i + 1 candidates, all drawn anew for each seed; keep x and y together";
    expect_that(
        mean_low < low,
        fmt::format("{}: mean power {:.4f} over 0 < |k| <= sqrt(N)/2", got.call, mean_low),
        fmt::format("less than {:.3f}; c = 1 has 0.11 for N = 64, 0.09 for 256, 0.08 above", low),
        "independent points have 1, jittered ones 0.33, ten candidates each 0.19", rule);
    expect_that(radii[sets / 2] > radius,
                fmt::format("{}: the median relative radius is {:.3f}", got.call, radii[sets / 2]),
                fmt::format("more than {:.3f}; c = 1 has 0.64 for N = 64, 0.67 for 256", radius),
                "too few candidates let the last points come close", rule);
  }
}

CHECK_CASE("6.7 each point is uniform over seeds", "[6.7][points:2][needs:4]") {
  for (const std::size_t i : {0u, 1u, 8u, 15u}) {
    const Randomness claim{.words = "each point is uniform in the square over seeds",
                           .rule = "each point, also the first, is random and depends on the seed",
                           .repeated = numbers_repeat};
    expect_random_seeds(sample_of("blue_noise", 16, i, {2}, claim), {domain::seeds(rng, 600)});
  }
  const SampleSets got = columns_of("blue_noise", 16, domain::seeds(rng, 600), {2});
  // The vectors from the first point to the second, modulo 1, to nine digits.
  std::set<std::array<long, 2>> vectors;
  for (std::size_t set = 0; set < got.size(); ++set) {
    const auto apart = [&](std::size_t d) {
      const double off = got.column(set, d)[1] - got.column(set, d)[0];
      return std::lround(1e9 * (off - std::floor(off)));
    };
    vectors.insert({apart(0), apart(1)});
  }
  expect_that(vectors.size() == got.size(),
              fmt::format("{}: {} different vectors from the first point to the second", got.call,
                          vectors.size()),
              fmt::format("{}, one for each seed", got.size()),
              "different seeds give unrelated numbers",
              "a pattern that is shifted is not a new one: make it with the seed's generator");
}

CHECK_CASE("6.7 blue noise has exactly N points for any N", "[6.7][points:1][needs:4]") {
  for (const std::size_t n : domain::sizes(600, rng)) {
    const SampleSets got = columns_of("blue_noise", n, {fresh_seed(rng)}, {2});
    expect_that(least_distance(got.column(0, 0), got.column(0, 1)) > 0,
                got.call + ": two points are at the same place", "N different points",
                "best candidates are never equal", "use each point of the pattern once");
  }
}

CHECK_CASE("6.7 the other dimensions of blue_noise are stratified",
           "[6.7][points:2][needs:6.2][needs:3]") {
  const Uses uses{2, 1, 2, 1, 2};
  for (const std::size_t n : {509u, 64u, 12u, 3u, 2u, 1u}) {
    const SampleSets got = columns_of("blue_noise", n, {fresh_seed(rng)}, uses);
    for (const std::size_t c : {3u, 6u}) expect_multi_jittered(got, c);
    for (const std::size_t c : {2u, 5u}) {
      expect_one_in_each_cell(got, 0, line_of(n, c), "a next() is stratified_1d, shuffled");
    }
  }
  for (const std::size_t i : {0u, 7u}) {
    const Randomness claim{.words = "different columns are independent",
                           .rule = "use a different permutation for each sample dimension",
                           .repeated = numbers_repeat};
    expect_random_seeds(sample_of("blue_noise", 12, i, uses, claim), {domain::seeds(rng, 600)});
  }
}

std::vector<BlueSets> blue_sets(Rng& rng) {
  const auto few = 55 + rng() % 26, some = 200 + rng() % 101, many = 1025 + rng() % 76;
  const auto between = [](double low, double high, double at) { return low + (high - low) * at; };
  const double radius_few = between(0.615, 0.627, static_cast<double>(few - 55) / 25),
               radius_some = between(0.636, 0.648, static_cast<double>(some - 200) / 100);
  return {{some, 21, {2}, 0.11, radius_some},
          {some, 21, {1, 2}, 0.11, radius_some},
          {many, 1, {1, 1, 2}, 0.11, 0},
          {few, 241, {2}, 0.0907 + 1.9 / static_cast<double>(few), radius_few}};
}

}  // namespace
}  // namespace mc::checks
