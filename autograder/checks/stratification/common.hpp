#pragma once
// Shared by the checks of lab 3: claims about jitter, refused grids, and errors of estimates,
// compared with their exact variances. The submission sends points; it does not see the integrands.

#include "3-stratification/experiments.hpp"
#include "checks/support/constructions.hpp"
#include "checks/support/exact_stratified.hpp"

namespace mc::checks {

using Sets = SampleSets;

/// The alpha of each of the at most 110 random tests of lab 3: 5e-7 in total.
constexpr double alpha = 4.5e-9;

/// Point sets with one point in each cell of their patterns.
struct Stratified {
  std::string task;
  std::function<Sets(std::size_t sets, std::uint64_t seed)> make;  ///< sets in turn
  std::vector<Pattern> patterns;
  std::string rule;  ///< for points that do not show what is wrong

  Sets some(std::size_t sets, Rng& rng) const { return make(sets, fresh_seed(rng)); }

  /// Exactly one point in each cell.
  void expect_cells(std::size_t sets, Rng& rng) const {
    expect_one_in_each_cell(some(sets, rng), patterns, rule);
  }
  /// New points in each set and for each seed.
  void expect_new_points(Rng& rng) const { expect_fresh(some(2, rng), some(1, rng), patterns); }

  /// The places of points in their cells, to be judged by expect_random_calls().
  Construction jitters(const Likely& same = "draw one for every coordinate"_likely) const {
    return {
        {.words = "points are uniform in the cells of " + task + ", and independent",
         .alpha = alpha,
         .rule = "each point is (i + u) / n with its own u, uniform in [0, 1)",
         .repeated =
             "random numbers repeat: draw new ones for each point, set, block and stream"_likely,
         .same = same},
        [*this](std::uint64_t seed, std::size_t sets) {
          return jitters_of(make(sets, seed), patterns, rule);
        }};
  }
};

/// A function of a point, and the exact moments of its estimates for some n.
struct Level {
  std::string words;  ///< "exp(x)"
  std::function<double(View)> f;
  double mean, variance;
  double kurtosis = 3;
  double independent = 0;  ///< the variance for the same number of independent points
  std::string because = "one point in each stratum leaves the variance within the strata";
};

inline constexpr auto exponential = [](double x) { return std::exp(x); };
inline constexpr auto centered_exponential = [](double x) { return std::exp(x - 0.5); };
inline constexpr auto gaussian = [](double x) { return std::exp(-x * x); };
inline constexpr auto centered = [](double x) { return x - 0.5; };

inline auto sum_over_axes(double (*h)(double)) {
  return [h](View x) {
    return std::accumulate(x.begin(), x.end(), 0.0,
                           [&](double all, double one) { return all + h(one); });
  };
}
inline auto product_over_axes(double (*h)(double)) {
  return [h](View x) {
    return std::accumulate(x.begin(), x.end(), 1.0,
                           [&](double all, double one) { return all * h(one); });
  };
}

inline Level level_of(std::string words, std::function<double(View)> f, const WithinStrata& strata,
                      double kurtosis = 3) {
  return {std::move(words), std::move(f),
          mean_of(strata),  stratified_variance(strata),
          kurtosis,         independent_variance(strata, strata.size())};
}

/// The mean squared error of estimates over the first `used` points (0: all) is the exact variance.
inline void expect_level(const Sets& sets, const Level& level, std::size_t used = 0) {
  if (used == 0) used = sets.n;
  Values estimates, point(sets.dims);
  for (std::size_t set = 0; set < sets.size(); ++set) {
    std::vector<View> columns;
    for (std::size_t d = 0; d < sets.dims; ++d) columns.push_back(sets.column(set, d));
    double sum = 0;
    for (std::size_t k = 0; k < used; ++k) {
      for (std::size_t d = 0; d < sets.dims; ++d) point[d] = columns[d][k];
      sum += level.f(point);
    }
    estimates.push_back(sum / static_cast<double>(used));
  }
  expect_variance(
      {fmt::format("{}, estimates of {}", sets.call, level.words), estimates,
       static_cast<double>(used)},
      level.mean, level.variance, level.kurtosis,
      {fmt::format("the error of {} over {} points: {}", level.words, used, level.because), alpha},
      {{{level.independent / level.variance,
         "this is the variance of independent points: the gain of stratification is lost"_likely}},
       "each point must be uniform in its stratum and independent of the others"});
}

/// Estimates of `evaluations` points each, with error bars from `replicates` means.
struct ReplicatedEstimates {
  std::string call;
  const std::vector<Estimate>& estimates;
  std::size_t evaluations, replicates;
};

/// Estimate.n is right, no estimate occurs twice, and the estimates have their exact mean and
/// variance; `variance` and `kurtosis` are those of the mean of one replicate.
inline void expect_estimates(const ReplicatedEstimates& got, double exact, double variance,
                             double kurtosis, const Hints& of_variance, const Hints& of_mean = {}) {
  Values values;
  for (const Estimate& one : got.estimates) {
    expect_equal(got.call + ": Estimate.n", one.n, got.evaluations, "",
                 "Estimate.n counts evaluations: those of all replicates");
    values.push_back(one.value);
  }
  Values sorted = values;
  std::ranges::sort(sorted);
  const auto twice = std::ranges::adjacent_find(sorted);
  expect_that(twice == sorted.end(),
              fmt::format("{}: two of {} estimates are {}", got.call, sorted.size(),
                          twice == sorted.end() ? 0 : *twice),
              "estimates that are all different", "random numbers never give the same mean",
              "draw from the generator that is passed in, not from a copy");
  const auto r = static_cast<double>(got.replicates);
  const Replicates all{got.call, values, static_cast<double>(got.evaluations)};
  expect_mean(all, exact, variance / r, {"the mean of estimates is the integral", alpha}, of_mean);
  expect_variance(
      all, exact, variance / r, 3 + (kurtosis - 3) / r,
      {"replicated estimates have 1/replicates of the variance within the strata", alpha},
      of_variance);
}

/// The mean square of the error bars is right: for Gaussian means, the sample variance of R of them
/// is chi-squared with R - 1 degrees of freedom, so each counts as R - 1 replicates.
inline void expect_bars(const ReplicatedEstimates& got, double variance, double kurtosis,
                        const Hints& hints) {
  const auto r = static_cast<double>(got.replicates);
  Values deviations;
  for (const Estimate& one : got.estimates) {
    deviations.insert(deviations.end(), got.replicates - 1, one.standard_error * std::sqrt(r));
  }
  expect_variance({got.call + ", standard_error * sqrt(replicates)", deviations}, 0, variance,
                  3 + (kurtosis - 3) * (r - 1) / r,
                  {"the mean square of error bars is the variance of an estimate", alpha}, hints);
}

}  // namespace mc::checks
