// 6.7: blue noise where it is seen, in the first next2().

#include <cmath>

#include "checks/sampler/planes.hpp"
#include "checks/sampler/relations.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/spectrum.hpp"

namespace mc::checks {
namespace {

/// The smallest distance on the torus.
double least_distance(View x, View y) {
  double least = 2;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto round = [](double d) { return d - std::round(d); };
      least = std::min(least, std::hypot(round(x[i] - x[j]), round(y[i] - y[j])));
    }
  }
  return least;
}

CHECK_CASE("6.7 the first next2 is blue noise", "[6.7][main][points:4][needs:4]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 256, sets = 40;
  double low = 0, radius = 0, radius_alone = 0;  // alone: no use before it
  std::string call;
  Values all;
  for (std::size_t set = 0; set < sets; ++set) {
    // Asked for after something else: it is the first next2() all the same.
    const Uses uses = set % 2 == 0 ? Uses{2} : Uses{1, 2};
    const Columns got = columns_of("blue_noise", n, {fresh_seed(rng)}, uses);
    const View x = got[got.dims - 2], y = got[got.dims - 1];
    all.insert(all.end(), x.begin(), x.end());
    low += low_band(spectrum_of(x, y, 8), n) / sets;
    const double of_set = least_distance(x, y) / std::sqrt(2 / (std::sqrt(3) * n));
    radius += of_set / sets;  // relative to that of the hexagonal lattice
    if (set % 2 == 0) radius_alone += of_set / (sets / 2);
    call = got.call;
  }
  // One set has a standard deviation of 0.0075: 34 of them, for forty, between 0.089 and 0.13.
  const std::string hint =
      radius <= 0.6 && radius_alone > 0.6
          ? "the first next2() is blue noise also where a next() comes before"
      : low > 0.25 ? "the first next2() is best_candidate of lab 4, with c = 1; x and y "
                     "of a point stay together"
                   : "as blue as a fixed number of candidates";
  expect_that(low < 0.13,
              fmt::format("{} and others: mean power {:.4f} over 0 < |k| <= 8, mean of {} sets",
                          call, low, sets),
              "less than 0.13; 0.089 on average for best candidates",
              "independent points have 1, jittered ones 0.33, ten candidates each 0.19", hint);
  expect_that(radius > 0.6,
              fmt::format("{} and others: the closest two are {:.3f} of the densest pattern's "
                          "distance apart, mean of {} sets",
                          call, radius, sets),
              "more than 0.6; 0.667 on average for best candidates",
              "a fixed number of candidates lets the last points come close", hint);
  expect_independent_uniforms(
      columns_of("blue_noise", 4, fresh_seeds(rng, 600), {2}).first_samples(),
      {.words = "the first sample is uniform over seeds",
       .alpha = alpha,
       .otherwise = "does every pattern begin at the same place?",
       .repeated = "does every pattern begin at the same place? " + same_for_seeds,
       .same = "does every pattern begin at the same place? " + same_for_seeds});
  check_all_different(call + " and others", all, "forty sets",
                      "no two points of a set are one, and no point is in every set");
}

CHECK_CASE("6.7 blue noise has exactly N points for any N", "[6.7][points:2][needs:4]") {
  Rng rng = check_rng();
  for (const std::size_t n : {509u, 7u, 3u, 2u, 1u}) {
    const Columns got = columns_of("blue_noise", n, {fresh_seed(rng)}, {2});
    for (std::size_t c = 0; c < 2; ++c) {
      check_all_different(got.call, Values(got[c].begin(), got[c].end()), c == 0 ? "x" : "y",
                          "blue noise never has a point twice");
    }
  }
}

CHECK_CASE("6.7 all else of blue_noise is stratified", "[6.7][points:2][needs:6.2][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : {509u, 12u, 3u}) {
    const Columns got = columns_of("blue_noise", n, {fresh_seed(rng)}, {2, 1, 2, 1});
    for (const std::size_t c : {2u, 5u}) {
      expect_one_in_each(got.call, "next()", got[c], n, "a next() is stratified_1d, shuffled");
    }
    check_multi_jittered(got.call + ", the second next2()", got[3], got[4]);
    if (n != 509) continue;
    for (const std::size_t c : {2u, 3u, 4u, 5u}) {
      check_unrelated(got.call, got[0], got[c], fmt::format("the blue x and coordinate {}", c),
                      "each sample dimension needs a permutation of its own");
    }
  }
}

}  // namespace
}  // namespace mc::checks
