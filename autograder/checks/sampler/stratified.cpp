// 6.2: every sample dimension stratified, in an order of its own.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "checks/sampler/planes.hpp"
#include "checks/sampler/samplers.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/inversions.hpp"
#include "checks/support/known_scenes.hpp"
#include "checks/support/measure.hpp"

namespace mc::checks {
namespace {

// Of 40,009 numbers kept as floats 16 leave their stratum, on average; of 10,007 but one does.
std::vector<std::uint64_t> sizes(Rng& rng) {
  auto all = domain::sizes(5000, rng);
  all.insert(all.end() - 1, 40009);
  return all;
}

CHECK_CASE("6.2 next has one number in each of N strata", "[6.2][points:4][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : sizes(rng)) {
    const Columns got = columns_of("stratified", n, {fresh_seed(rng)}, {1, 1, 1});
    for (std::size_t c = 0; c < got.dims; ++c) {
      expect_one_in_each(got.call, fmt::format("next() {}", c).c_str(), got[c], n,
                         "a next() is stratified_1d, shuffled");
    }
  }
}

CHECK_CASE("6.2 next2 has one point in each cell and stratum", "[6.2][main][points:5][needs:3]") {
  Rng rng = check_rng();
  for (const std::size_t n : sizes(rng)) {
    const Columns got = columns_of("stratified", n, {fresh_seed(rng)}, {2, 2});
    for (std::size_t c = 0; c < got.dims; c += 2)
      check_multi_jittered(got.call, got[c], got[c + 1]);
  }
}

/// The coordinates whose order is free: next(), and x of next2(), which decides about y.
std::vector<std::size_t> free_coordinates(const Uses& uses) {
  std::vector<std::size_t> free;
  std::size_t c = 0;
  for (const unsigned use : uses) free.push_back(c), c += use;
  return free;
}

/// In which strata the samples are, as the uniform numbers that decide about a permutation; of each
/// set and each free coordinate.
Uniforms orders_of(const Columns& got, const std::vector<std::size_t>& coordinates, Rng& rng) {
  Uniforms orders{got.call, coordinates.size() * (got.n - 1)};
  orders.name = [=, n = got.n](std::size_t position) {
    return fmt::format("choice {} of the permutation of coordinate {}", position % (n - 1),
                       coordinates[position / (n - 1)]);
  };
  for (std::size_t set = 0; set < got.sets(); ++set) {
    for (const std::size_t c : coordinates) {
      std::vector<std::size_t> strata;
      for (const double x : got(set, c)) strata.push_back(stratum_of(x, got.n).value_or(0));
      if (!is_stratified(got(set, c), got.n)) {
        expect_one_in_each(got.call, fmt::format("coordinate {}", c).c_str(), got(set, c), got.n,
                           "a column has one number in each stratum");
      }
      const Values more = uniforms_of_permutation(strata, rng);
      orders.values.insert(orders.values.end(), more.begin(), more.end());
    }
  }
  return orders;
}

CHECK_CASE("6.2 each sample dimension has a permutation of its own", "[6.2][points:5][needs:3]") {
  Rng rng = check_rng();
  const Randomness permuted{
      .words = "each sample dimension is in an independent random permutation",
      .alpha = alpha,
      .otherwise =
          "the pattern must be shuffled, by a permutation of its own for each sample "
          "dimension and each seed",
      .repeated = same_for_seeds,
      .same = "one permutation for different sample dimensions: each needs a shuffle of its own"};
  const auto share_an_order = [](const Columns& got, const std::vector<std::size_t>& coordinates) {
    const auto is_same = [&](std::size_t a, std::size_t b) {
      for (std::size_t i = 0; i < got.n; ++i) {
        if (stratum_of(got[a][i], got.n) != stratum_of(got[b][i], got.n)) return false;
      }
      return true;
    };
    for (const std::size_t a : coordinates) {
      for (const std::size_t b : coordinates) {
        if (a < b && is_same(a, b)) return true;
      }
    }
    return false;
  };
  const auto is_in_order = [](const Columns& got) {
    for (std::size_t i = 0; i < got.n; ++i) {
      if (stratum_of(got[0][i], got.n) != i) return false;
    }
    return true;
  };
  for (const auto& [n, uses, sets] :
       {std::tuple{std::size_t{12}, repeated(6, {1, 2}), std::size_t{300}},
        {std::size_t{5}, repeated(17, {2, 1}), std::size_t{300}},
        {std::size_t{10007}, Uses{1, 2, 1}, std::size_t{1}}}) {
    const Columns got = columns_of("stratified", n, fresh_seeds(rng, sets), uses);
    const auto coordinates = free_coordinates(uses);
    const Uniforms orders = orders_of(got, coordinates, rng);
    auto failure = dependence_in(orders, permuted);
    if (failure && share_an_order(got, coordinates)) failure->likely = permuted.same;
    if (failure && is_in_order(got)) {
      failure->likely = "the strata come in order: the pattern must be shuffled";
    }
    if (failure) fail(*failure);
    // Where a point lies within its stratum: uniform, and of its own for every sample dimension.
    Uniforms jitters{got.call, got.dims * n};
    jitters.bits = bits_of_jitter(n);
    for (const double x : got.all) jitters.values.push_back(jitter_of(x, n));
    expect_independent_uniforms(
        jitters, {.words = "points are uniform in their strata, each by a number of its own",
                  .alpha = alpha,
                  .otherwise = "points are uniform in their strata: a number for each",
                  .repeated = same_for_seeds});
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
