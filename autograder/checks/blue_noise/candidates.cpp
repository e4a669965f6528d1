// 4.2
//
// Blue is judged by bounds on means over at least 40 sets of about 256 points. Where they stand
// between right and wrong, in standard deviations of the judged mean (200 sets of each kind
// measured for the figures; for Poisson disks see poisson_disks.cpp):
//
//                             best candidate   fixed 10   jittered   Halton   bound
//   low band, mean            .0890            .1912      .3254      .2654    < .13
//   low band, sd of one set   .0075            .0192      .0367      0
//   sd of the mean of 64      .0009            .0024      .0046
//   to the bound              44 sigma         25 sigma   42 sigma   certain
//   relative radius, mean     .667             .453       .118       .344     > .6
//   sd of one set, of 64      .014, .0018      .042, .0053
//   to the bound              37 sigma         28 sigma
//   Poisson disks have .76, and are not best candidates: < .72, 29 sigma away
//
// At 7 sigma a Gaussian errs once in 10^12.

#include <array>
#include <cmath>
#include <deque>

#include <fmt/format.h>

#include "checks/blue_noise/nearness.hpp"
#include "checks/support/battery.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/discs.hpp"
#include "checks/support/refusals.hpp"
#include "checks/support/statistics.hpp"

namespace mc::checks {

CHECK_CASE("4.2 each point is the best of its candidates", "[4.2][main][points:10][needs:4.1]") {
  Rng rng = check_rng();
  // c = 1 tells a candidate that is missing from c i rounded down; for other c they are the same.
  const std::array<double, 3> cases[] = {
      // n, c, sets
      {5, 1, 400},   {5, 0.4, 400}, {5, uniform(rng, 2.5, 3), 400}, {3, 20, 200}, {17, 1e-9, 60},
      {65, 0.1, 12}, {2, 1, 400}};
  for (const auto& [points, c, count] : cases) {
    const auto n = static_cast<std::size_t>(points), sets = static_cast<std::size_t>(count);
    const auto got = MEASURE(best_candidate, n, c, sets, fresh_seed(rng));
    const auto all = sets_of(got, n, sets);
    std::vector<Nearness> parts;
    for (const Set& set : all) {
      for (std::size_t i = 1; i < n; ++i) parts.push_back(nearness(set, i, 500, rng));
    }
    std::string likely;
    if (n == 5 && !have_candidates(parts, [=](double i) { return std::ceil(c * i) + 1; })) {
      constexpr std::size_t more = 4000;
      const auto again = MEASURE(best_candidate, n, c, more, fresh_seed(rng));
      likely = candidates_hint(sets_of(again, n, more), c);
    }
    expect_candidates(got.call, parts, c, likely);
    if (n == 5) require_fine(got.call, all);
  }
  // The first point has one candidate, anywhere in the square.
  const auto got = MEASURE(best_candidate, 1, 1, 2000, fresh_seed(rng));
  Uniforms first{got.call, 2};
  for (const Set& set : sets_of(got, 1, 2000)) {
    first.values.insert(first.values.end(), {set.x[0], set.y[0]});
  }
  expect_independent_uniforms(
      first, {.words = "the first point is uniform in the square",
              .alpha = alpha,
              .otherwise = "the first point has one candidate, anywhere in the square"});
}

CHECK_CASE("4.2 best candidates are blue", "[4.2][points:6][needs:4.1]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 256, sets = 64, calls = 4;
  std::deque<Measured<Points>> got;  // in four calls, so that three plain loops are in time
  std::vector<Set> all;
  for (std::size_t call = 0; call < calls; ++call) {
    got.push_back(MEASURE(best_candidate, n, 1, sets / calls, fresh_seed(rng)));
    for (const Set& set : sets_of(got.back(), n, sets / calls)) all.push_back(set);
  }
  const std::string& what = got[0].call;
  double radius = 0;
  for (const Set& set : all) radius += least_distance(set.x, set.y) / lattice_distance(n) / sets;
  const Spectrum mean = mean_spectrum(all, n);
  const double low = low_band(mean, n);
  const std::string likely =
      "the first check of 4.2 asks for each point by itself: for the farthest of ceil(c i) + 1 "
      "candidates from all points before, round the torus";
  expect_that(
      low < 0.13,
      fmt::format("{}: mean power {:.4f} over 0 < |k| <= 8, mean of {} sets", what, low, sets),
      "less than 0.13; 0.088 on average",
      "independent points have 1, jittered ones 0.32, ten candidates for every point 0.19", likely);
  expect_that(radius > 0.6 && radius < 0.72,
              fmt::format("{}: the closest two are {:.3f} of the densest pattern's distance apart, "
                          "mean of {} sets",
                          what, radius, sets),
              "0.6 to 0.72; 0.67 on average",
              "a fixed number of candidates lets the last points come close: 0.46", likely);
  expect_no_lattice(what, mean, sets);
}

static std::vector<InvalidCall> wrong_candidates() {
  const std::string size = "each point has two coordinates, and there is at least one point";
  std::vector<InvalidCall> calls{
      {MEASURE_OUTCOME(best_candidate_into, 3, 4, 1), "x|y|size", size},
      {MEASURE_OUTCOME(best_candidate_into, 4, 3, 1), "x|y|size", size},
      {MEASURE_OUTCOME(best_candidate_into, 0, 3, 1), "x|y|size", size},
      {MEASURE_OUTCOME(best_candidate_into, 3, 0, 1), "x|y|size", size},
      {MEASURE_OUTCOME(best_candidate_into, 0, 0, 1), "x|y|size|point", size}};
  for (const double c : {0.0, -0.0, -1.0, -1e-9, -1e300, nan, infinity, -infinity}) {
    calls.push_back({MEASURE_OUTCOME(best_candidate_into, 3, 3, c), "c",
                     "c, the candidates for each earlier point, is positive and finite"});
  }
  return calls;
}

CHECK_CASE("4.2 misuse of best_candidate is refused", "[4.2][edge][points:2]") {
  expect_refused(wrong_candidates());
}

CHECK_CASE("4.2 a refusal names the argument", "[4.2][edge][points:1]") {
  expect_argument_named(wrong_candidates());
}

}  // namespace mc::checks
