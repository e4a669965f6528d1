// 4.2
//
// "Blue" is judged by bounds on means over at least 40 sets of about 256 points. Their distances
// from correct and wrong answers, in standard deviations of the judged mean (from 200 sets of each
// kind; for Poisson disks see poisson_disks.cpp):
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
// A Gaussian exceeds 7 sigma once in 10^12.

#include "checks/blue_noise/random_sets.hpp"
#include "checks/support/disks.hpp"

namespace mc::checks {

/// Tests the number of candidates of each point in a few sets. The hint needs thousands of sets.
static void judge_candidates(std::size_t n, double c, std::size_t sets, Rng& rng,
                             std::size_t rows = 500) {
  const auto got = MEASURE(best_candidate, n, c, sets, fresh_seed(rng));
  const SampleSets all = random_sets(got, n, sets);
  if (n == 5) require_fine(all);
  const Nearness parts = nearness(all, later_points(n), rows, rng);
  Randomness claim = best_of_candidates(
      "draw ceil(c i) + 1 new candidates, of two random numbers each, for point i, and keep the "
      "one that is farthest from its nearest earlier point, also where cells of a grid find it");
  claim.explain = [&]() -> std::string {
    constexpr std::size_t more = 4000;
    if (n != 5) return {};
    const auto again = MEASURE(best_candidate, n, c, more, fresh_seed(rng));
    return candidates_hint(random_sets(again, n, more), c, rng);
  };
  expect_independent_uniforms(by_candidates(got.call, parts, promised(c)), claim);
}

CHECK_CASE("4.2 each point is the best of its candidates", "[4.2][main][points:8][needs:4.1]") {
  // Only c = 1 distinguishes a missing candidate from c i rounded down.
  // If candidates are stratified along an axis, the distribution is 0.03 to 0.05 off.
  judge_candidates(5, 1, 4000, rng, 200);
  judge_candidates(5, uniform(rng, 2.5, 3), 400, rng);
  judge_candidates(8, 0.5, 200, rng);
  judge_candidates(65, 0.1, 12, rng);
}

CHECK_CASE("4.2 any number of points and candidates", "[4.2][edge][points:3][needs:4.1]") {
  judge_candidates(5, 1 + 1e-12, 400, rng);  // a float c or a tolerance loses a candidate
  judge_candidates(3, 20, 200, rng);
  judge_candidates(17, 1e-12, 60, rng);
  judge_candidates(2, 1, 400, rng);
  judge_candidates(2, 4999, 60, rng, 20000);    // finer rows: 1/5000 of the square is left
  judge_candidates(2, 69999, 20, rng, 300000);  // more candidates than 16 bits can count
  const auto got = MEASURE(best_candidate, 1, 1, 2000, fresh_seed(rng));
  const SampleSets first = random_sets(got, 1, 2000);
  expect_independent_uniforms({got.call, 2, first.values()},
                              {.words = "the first point is uniform in the square",
                               .rule = "the first point has one candidate, uniform in the square"});
}

CHECK_CASE("4.2 also among a thousand points", "[4.2][points:2][needs:4.1]") {
  const double c = uniform(rng, 0.08, 0.12);  // three loops make 3e7 to 4e7 comparisons
  const auto got = MEASURE(best_candidate, 1000, c, 1, fresh_seed(rng));
  judge_points(random_sets(got, 1000, 1), c, 1, 1000, 400, rng);
}

CHECK_CASE("4.2 best candidates are blue", "[4.2][points:6][needs:4.1]") {
  constexpr std::size_t n = 256, sets = 64;
  const SampleSets all = in_four_calls([&] {
    return random_sets(MEASURE(best_candidate, n, 1, sets / 4, fresh_seed(rng)), n, sets / 4);
  });
  double radius = 0;
  for (std::size_t set = 0; set < sets; ++set) {
    radius += least_distance(all.column(set, 0), all.column(set, 1)) / lattice_distance(n) / sets;
  }
  const Spectrum mean = mean_spectrum(all, n);
  const double low = low_band(mean, n);
  const std::string likely =
      "each point is the candidate, of ceil(c i) + 1, that is farthest from all earlier points";
  expect_that(
      low < 0.13,
      fmt::format("{}: mean power {:.4f} over 0 < |k| <= 8, mean of {} sets", all.call, low, sets),
      "less than 0.13; 0.088 on average",
      "independent points have 1, jittered ones 0.32, ten candidates for every point 0.19", likely);
  expect_that(
      radius > 0.6 && radius < 0.72,
      fmt::format("{}: the relative radius is {:.3f}, mean of {} sets", all.call, radius, sets),
      "0.6 to 0.72; 0.67 on average",
      "with a fixed number of candidates, the last points come close: 0.46", likely);
  expect_no_lattice(all.call, mean, sets);
  require_everywhere(all);
}

static std::vector<InvalidCall> wrong_candidates() {
  std::vector<InvalidCall> calls = without_points([](std::uint64_t x, std::uint64_t y) {
    return MEASURE_OUTCOME(best_candidate_into, x, y, 1);
  });
  for (const double c : {0.0, -0.0, -1.0, -1e-9, -1e300, nan, infinity, -infinity}) {
    for (const std::uint64_t points : {3u, 1u}) {
      calls.push_back({MEASURE_OUTCOME(best_candidate_into, points, points, c), "c",
                       "c, the candidates for each earlier point, is positive and finite"});
    }
  }
  return calls;
}

REFUSAL_CASES("4.2", "misuse of best_candidate is refused", "2", "a refusal names the argument",
              "1", wrong_candidates())

}  // namespace mc::checks
