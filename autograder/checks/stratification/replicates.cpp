// 3.8: replicated estimates and their error bars. The values that are averaged reach the submission
// through the generator and the integrand only, which refuse to be called in another way than the
// header specifies.

#include "checks/stratification/common.hpp"

namespace mc::checks {
namespace {

/// A replicated mean of x0 + 2 x1 + …, whose coordinates are taken from a list of values.
struct ReplicateData {
  std::size_t n, dims, replicates;
  Values values;

  /// The means of the replicates, of which each column takes the next n values.
  Values means() const {
    Values all;
    for (std::size_t first = 0; first < values.size(); first += n * dims) {
      double total = 0;
      for (std::size_t k = 0; k < n * dims; ++k) {
        total += static_cast<double>(k / n + 1) * values[first + k];
      }
      all.push_back(total / static_cast<double>(n));
    }
    return all;
  }
};

ReplicateData random_data(Rng& rng, std::size_t n, std::size_t dims, std::size_t replicates) {
  return {n, dims, replicates, uniform_values(rng, n * dims * replicates, -1, 1)};
}

Measured<Estimate> estimate_of(const ReplicateData& data) {
  const auto got = MEASURE(estimate_replicated, data.values, data.n, data.dims, data.replicates);
  expect_equal(got.call + ": Estimate.n", got.value.n, data.n * data.replicates, "",
               "Estimate.n counts evaluations: n * replicates");
  return got;
}

/// Sums of at most 10006 values of size 1 lose 10006 eps; this is twice as much.
constexpr double rounding = 5e-12;

void compare_means(const std::vector<ReplicateData>& all) {
  for (const ReplicateData& data : all) {
    const auto got = estimate_of(data);
    const Values means = data.means();
    const double exact = sum_of(means) / static_cast<double>(data.replicates);
    const double value = got.value.value;
    expect_each({got.call + ".value", std::span(&value, 1)},
                {.exact = {exact},
                 .tolerance = {rounding},
                 .because = "the mean of all values",
                 .rule = "every point of every replicate counts once",
                 .is_tame = true});
  }
}

CHECK_CASE("3.8 the estimate is the mean of the replicates", "[3.8][main][points:4]") {
  compare_means({random_data(rng, 64, 1, 25), random_data(rng, 7, 3, 3), random_data(rng, 3, 9, 17),
                 random_data(rng, 50, 2, 4 + rng() % 20)});
}

CHECK_CASE("3.8 any number of points and replicates", "[3.8][edge][points:0.5]") {
  auto late = random_data(rng, 2, 1, 700);  // a rare event: the first means are equal
  std::fill_n(late.values.begin(), 1302, 0.5);
  compare_means({random_data(rng, 5003, 1, 2), random_data(rng, 2, 1, 1000), late,
                 random_data(rng, 100, 2, 1), random_data(rng, 2, 33, 3), random_data(rng, 1, 2, 3),
                 random_data(rng, 3, 1, 2), random_data(rng, 1, 1, 2), random_data(rng, 1, 1, 1)});
  for (const double odd : {infinity, -infinity, nan}) {
    const auto got = estimate_of({2, 1, 5, {0, 1, 0, 2, odd, 1, 0, 1, 0, 1}});
    expect_not_finite(got.call, got.value.value, "", "do not drop a mean that is infinite or NaN");
  }
}

CHECK_CASE("3.8 the error bar is the spread of the replicates", "[3.8][points:3]") {
  // With an offset of 1e6 the means have 52 - 20 fractional bits: errors of 1e-9. The textbook
  // formula has an error of 1e6^2 eps = 1e-4.
  for (auto data :
       {random_data(rng, 7, 1, 5), random_data(rng, 64, 2, 25), random_data(rng, 5, 1, 3),
        random_data(rng, 2, 1, 1000), random_data(rng, 1, 1, 2), random_data(rng, 8, 1, 20)}) {
    const bool is_far = data.replicates == 20;
    for (double& value : data.values) value += is_far ? 1e6 : 0;
    const Values means = data.means();
    const auto r = static_cast<double>(data.replicates), size = static_cast<double>(data.n);
    const double exact = std::sqrt(squared_deviations(means) / (r - 1) / r);
    const auto got = estimate_of(data);
    const double bar = got.value.standard_error;
    Comparison comparison{
        .exact = {exact},
        .tolerance = {is_far ? 1e-7 * exact : rounding},
        .because = "s / sqrt(replicates), with the standard deviation s of the replicates' means",
        .suspects =
            {{{exact * std::sqrt(r)},
              "this is the standard deviation of one mean: divide it by sqrt(replicates)"_likely},
             {{std::sqrt(squared_deviations(means)) / r},
              "this divides by replicates; a sample variance divides by replicates - 1"_likely},
             {{exact / std::sqrt(size)},
              "this divides by sqrt(n * replicates): divide by sqrt(replicates)"_likely}},
        .rule =
            "compute the variance with lab 1, from the replicates' means: E{X^2} - E{X}^2 "
            "cancels",
        .is_tame = !is_far};
    if (data.dims == 1) {
      comparison.suspects.push_back(
          {{std::sqrt(squared_deviations(data.values) / (size * r - 1) / (size * r))},
           "this is s / sqrt(n) over all points, as if they were independent"_likely});
    }
    expect_each({got.call + ".standard_error", std::span(&bar, 1)}, comparison);
  }
}

CHECK_CASE("3.8 estimates over stratified points have their exact error",
           "[3.8][points:1][needs:3.1]") {
  constexpr std::size_t n = 16, replicates = 9, times = 200;
  const experiments::Function g{1, (rng() % 2 == 0 ? 1 : -1) * uniform(rng, 0.5, 2),
                                uniform(rng, -1, 1), 0};
  const auto got = MEASURE(estimates_replicated, 1, g, 1, n, replicates, times, fresh_seed(rng));
  const WithinStrata strata = strata_of(exponential, n);
  expect_estimates({got.call, got.exactly(times), n * replicates, replicates},
                   g.a * mean_of(strata) + g.b, g.a * g.a * stratified_variance(strata), 3,
                   {{}, "draw fresh points from the same generator for each replicate"});
}

CHECK_CASE("3.8 one replicate has no error bar", "[3.8][edge][points:0.5]") {
  const auto one = estimate_of(random_data(rng, 10, 1, 1));
  expect_nan(one.call + ".standard_error", one.value.standard_error,
             "one mean has no spread, so the result is undefined");
}

}  // namespace
}  // namespace mc::checks
