// 4.3
// The distances of the bounds of "blue" from correct and wrong answers, in standard deviations of
// the judged mean (from 200 patterns of each kind; those of the reference are maximal):
//
//                             reference      Bridson, gaps filled   lattice   bound
//   low band, mean            .0741          .10                    0         < .13
//   low band, sd of one set   .0068
//   sd of the mean of 160     .0005 (80 sigma to the bound)
//   peak of 160 sets, sd      1.752, .019    1.53                   3 or more 1.4 to 1.9
//   to the bounds             18 and 8 sigma 7 sigma
// A Gaussian exceeds 7 sigma once in 10^12.

#include <cstdlib>

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/disks.hpp"

namespace mc::checks {
namespace {

/// Ends the check if two points are too close, or if the patterns were not filled at all; another
/// check tests how full they are.
SampleSets patterns(double radius, std::size_t sets, Rng& rng);
double mean_size(const SampleSets& sets);
double mean_uncovered(const SampleSets& sets, double radius, Rng& rng);

CHECK_CASE("4.3 no two points are closer than the radius", "[4.3][main][points:9][needs:4.1]") {
  const SampleSets all = patterns(uniform(rng, 0.05, 0.06), 40, rng);
  require_fine(all);
  expect_no_lattice(all.call, mean_spectrum(all, mean_size(all)), all.size());
  patterns(uniform(rng, 0.2, 0.4), 400, rng);
}

CHECK_CASE("4.3 any radius", "[4.3][edge][points:4][needs:4.1]") {
  // Radii with one or two points (0.6), with many (0.03), and just above sqrt(2) / 3: if the
  // cells' width radius / sqrt(2) is rounded up to 1 / integer there, cells are a third too large
  // and may hold two points. A point is lost in 11 % of such patterns: 200 miss it once in 10^10.
  const double just_above = uniform(rng, 1 + 1e-9, 1 + 1e-6);
  const std::pair<double, std::size_t> cases[] = {{uniform(rng, 0.5, 0.7), 20},
                                                  {std::sqrt(2.0) / 3 * just_above, 200},
                                                  {std::sqrt(2.0) / 4 * just_above, 200},
                                                  {0.125, 10},
                                                  {std::sqrt(0.5) / 16, 10},
                                                  {uniform(rng, 0.03, 0.035), 1}};
  for (const auto& [radius, sets] : cases) patterns(radius, sets, rng);
  for (const double radius : {uniform(rng, 0.72, 0.9), 1.0, uniform(rng, 1, 10), 0.70711,
                              std::nextafter(std::sqrt(0.5), 1), 1e300, infinity}) {
    const SampleSets all = patterns(radius, 5, rng);
    expect_that(all.values().size() == 10,
                fmt::format("{}: {} points in 5 sets", all.call, all.values().size() / 2),
                "one in each", "no two points on the torus are farther apart than sqrt(1/2)", "");
  }
  // Just below, a second point fits in a single place, which need not be found.
  for (const double radius : {0.7071, std::nextafter(std::sqrt(0.5), 0)}) patterns(radius, 5, rng);
}

CHECK_CASE("4.3 the pattern is nearly maximal", "[4.3][points:9][needs:4.1]") {
  // Means over enough patterns that correct and wrong answers are far from 0.3 %. Bridson's
  // algorithm with 30 tries leaves 0.9 to 1.1 % for radii from 0.61 to 0.65, with at most +- 1.8 %
  // per pattern: 200 patterns are 5 sigma above. Dropping a quarter cell of which only the center
  // is covered leaves 0.6 % at 0.65, and 0.46 % at 0.63. For smaller radii Bridson leaves too
  // little to detect: 0.17 % at 0.3 (up to 2.6 % in one of 4,000 patterns), 0.12 % below 0.1. Darts
  // until 1,000 misses in a row leave 0.19 % +- 0.09 % for 230 points, 0.5 % for 10,000: see 4.7.
  const std::pair<double, std::size_t> cases[] = {{uniform(rng, 0.05, 0.06), 40},
                                                  {uniform(rng, 0.28, 0.32), 60},
                                                  {uniform(rng, 0.14, 0.16), 40},
                                                  {uniform(rng, 0.61, 0.65), 200},
                                                  {uniform(rng, 0.645, 0.65), 200}};
  for (const auto& [radius, sets] : cases) {
    const SampleSets all = patterns(radius, sets, rng);
    const double uncovered = mean_uncovered(all, radius, rng);
    expect_that(
        uncovered <= 0.003,
        fmt::format("{}: {:.3g} % of the square is uncovered, mean of {} sets of {:.4g} points",
                    all.call, 100 * uncovered, sets, mean_size(all)),
        "0.3 % at most",
        "another point fits where no disk reaches (computed with an error of 0.01 %)",
        "gaps are left: a number of misses in a row does not prove that nothing fits, nor does a "
        "cell's covered center; drop no cell that still has room; two points may be as close as "
        "the "
        "radius");
  }
}

CHECK_CASE("4.3 Poisson disks are blue", "[4.3][points:5][needs:4.1]") {
  constexpr std::size_t sets = 160;  // enough for the peak of the mean
  const double radius = radius_for(256);
  const SampleSets all = patterns(radius, sets, rng);
  const double size = mean_size(all);
  const Spectrum mean = mean_spectrum(all, size);
  const double low = low_band(mean, size), top = peak(mean, size);
  expect_that(low < 0.13,
              fmt::format("{}: mean power {:.4f} over 0 < |k| <= sqrt(N)/2", all.call, low),
              "less than 0.13; 0.076 on average", "independent points have 1, jittered ones 0.32",
              "keep the distance and fill the square equally everywhere");
  expect_that(top > 1.4 && top < 1.9,
              fmt::format("{}: the largest mean power of a ring is {:.3f}", all.call, top),
              "1.4 to 1.9; 1.75 on average",
              "distances just above the radius are common, but not dominant",
              "new points must fall anywhere that is free, not only on rims of disks or a lattice");
  expect_no_lattice(all.call, mean, sets);
}

CHECK_CASE("4.3 points fall anywhere on the torus", "[4.3][points:2][needs:4.1]") {
  const double radius = uniform(rng, 0.2, 0.4);
  const SampleSets all = patterns(radius, 400, rng);
  Uniforms places{all.call + ", one point of each pattern", 2};
  for (std::size_t set = 0; set < all.size(); ++set) {
    const std::size_t point = rng() % all.points(set);
    for (const std::size_t d : {0u, 1u}) places.values.push_back(all.column(set, d)[point]);
  }
  expect_independent_uniforms(
      places, {.words = "a random point of each pattern is uniform in the square",
               .rule = "points must fall anywhere on the torus with equal probability"});
  require_everywhere(all);
  require_everywhere(patterns(uniform(rng, 0.05, 0.06), 40, rng));
}

SampleSets patterns(double radius, std::size_t sets, Rng& rng) {
  // Few points per call: darts that are compared with all points until 10,000 miss in a row are
  // right, too, and take 0.06 s of CPU time for 230 points.
  const auto points = 0.7 / (radius * radius);
  const auto most = static_cast<std::size_t>(std::clamp(1200 / points, 1.0, 100.0));
  std::optional<SampleSets> made;
  for (std::size_t left = sets; left > 0;) {
    const std::size_t count = std::min(left, most);
    const auto got = MEASURE(poisson_disk, radius, count, fresh_seed(rng));
    const SampleSets some = random_sets(got, radius, count);
    if (made) {
      made->add(some);
    } else {
      made = some;
    }
    left -= count;
  }
  const SampleSets& all = *made;
  const double size = mean_size(all);
  expect_that(size > 0.1 / radius / radius,
              fmt::format("{}: {:.1f} points per set on average", all.call, size),
              fmt::format("about {:.0f}", 0.7 / radius / radius),
              "there is room for about 0.7 / radius^2 points", "add points until no more fit");
  return all;
}

double mean_size(const SampleSets& sets) {
  return static_cast<double>(sets.values().size()) / 2 / static_cast<double>(sets.size());
}

/// The fraction of the square without a disk, as a mean over sets.
double mean_uncovered(const SampleSets& sets, double radius, Rng& rng) {
  double sum = 0;
  for (std::size_t set = 0; set < sets.size(); ++set) {
    sum += uncovered_area(sets.column(set, 0), sets.column(set, 1), radius, 1000, uniform(rng));
  }
  return sum / static_cast<double>(sets.size());
}

}  // namespace
}  // namespace mc::checks
