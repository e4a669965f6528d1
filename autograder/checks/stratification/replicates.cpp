// 3.8: replicated estimates and their error bars.

#include "checks/stratification/common.hpp"

namespace mc::checks {
namespace {

using experiments::ReplicatedEstimate;

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

double standard_error(const Values& means) {
  const auto r = static_cast<double>(means.size());
  return std::sqrt(squared_deviations(means) / (r - 1) / r);
}

/// Sums of at most 10006 values of size 1 lose 10006 eps; this is twice as much.
constexpr double rounding = 5e-12;

/// Each replicate has its own set of n points, and g is evaluated once per point.
void require_work(const std::string& call, const ReplicatedEstimate& got, std::size_t n,
                  std::size_t replicates) {
  const struct {
    const char* what;
    std::uint64_t count, expected;
    const char* hint;
  } counts[] = {
      {"calls of the generator", got.generated, replicates,
       "each replicate has its own point set, made in one call"},
      {"calls with a set or a point of the wrong size", got.misshapen, 0,
       "the generator fills a PointSet(n, g.dims); g.f takes g.dims coordinates"},
      {"evaluations of the integrand", got.evaluated, n * replicates,
       "evaluate the integrand once per point"},
      {"Estimate.n", got.n, n * replicates, "Estimate.n counts evaluations: n * replicates"},
      {"calls of the generator with repeated random numbers", got.repeated, 0,
       "replicates must be independent: draw fresh points from the same generator, not a copy"}};
  for (const auto& [what, count, expected, hint] : counts) {
    expect_equal(fmt::format("{}: {}", call, what), count, expected, "", hint);
  }
}

CHECK_CASE("3.8 the estimate is the mean of the replicates", "[3.8][main][points:2]") {
  auto late = random_data(rng, 2, 1, 700);  // a rare event: the first means are equal
  std::fill_n(late.values.begin(), 1302, 0.5);
  for (const auto& data :
       {random_data(rng, 64, 1, 25), random_data(rng, 7, 3, 3), random_data(rng, 3, 9, 17),
        random_data(rng, 5003, 1, 2), random_data(rng, 2, 1, 1000), late,
        random_data(rng, 100, 2, 1), random_data(rng, 1, 1, 2)}) {
    const auto [n, dims, replicates, values] = data;
    const auto got = MEASURE(estimate_replicated, values, n, dims, replicates);
    require_work(got.call, got.value, n, replicates);
    const Values means = data.means();
    const auto r = static_cast<double>(replicates), size = static_cast<double>(n);
    const double exact = sum_of(means) / r, value = got.value.value;
    expect_each({got.call + ".value", std::span(&value, 1)},
                {.exact = {exact},
                 .tolerance = {rounding},
                 .because = "the mean of all values",
                 .suspects = {{{exact * size * r}, "this is the sum: divide it by n * replicates"},
                              {{exact * r}, "this is the sum of the replicates' means"},
                              {{exact * size}, "divide by n too"},
                              {{means.back()}, "this is the mean of the last replicate"},
                              {{means.front()}, "this is the mean of the first replicate"}},
                 .rule = "every point of every replicate counts once",
                 .is_tame = true});
  }
  for (const double odd : {infinity, -infinity, nan}) {
    const auto got = MEASURE(estimate_replicated, {0, 1, 0, 2, odd, 1, 0, 1, 0, 1}, 2, 1, 5);
    require_work(got.call, got.value, 2, 5);
    expect_not_finite(got.call, got.value.value, "", "do not drop a mean that is infinite or NaN");
  }
}

CHECK_CASE("3.8 the error bar is the spread of the replicates", "[3.8][points:2]") {
  // With an offset of 1e6 the means have 52 - 20 fractional bits: errors of 1e-9. The textbook
  // formula has an error of 1e6^2 eps = 1e-4.
  for (auto data :
       {random_data(rng, 7, 1, 5), random_data(rng, 64, 2, 25), random_data(rng, 5, 1, 3),
        random_data(rng, 2, 1, 1000), random_data(rng, 1, 1, 2), random_data(rng, 8, 1, 20)}) {
    const bool is_far = data.replicates == 20;
    for (double& value : data.values) value += is_far ? 1e6 : 0;
    const auto [n, dims, replicates, values] = data;
    const Values means = data.means();
    const auto r = static_cast<double>(replicates), size = static_cast<double>(n);
    const double exact = standard_error(means);
    const auto got = MEASURE(estimate_replicated, values, n, dims, replicates);
    const double bar = got.value.standard_error;
    Comparison comparison{
        .exact = {exact},
        .tolerance = {is_far ? 1e-7 * exact : rounding},
        .because = "s / sqrt(replicates), with the standard deviation s of the replicates' means",
        .suspects = {{{exact * std::sqrt(r)},
                      "this is the standard deviation of one mean: divide it by sqrt(replicates)"},
                     {{std::sqrt(squared_deviations(means)) / r},
                      "this divides by replicates; a sample variance divides by replicates - 1"},
                     {{exact / std::sqrt(size)},
                      "this divides by sqrt(n * replicates): divide by sqrt(replicates)"},
                     {{exact * exact},
                      "this is the variance of the estimate: take its square root"}},
        .rule = is_far ? "E{X^2} - E{X}^2 cancels: compute the variance with lab 1"
                       : "the replicates' means are independent: compute their variance with lab 1",
        .is_tame = !is_far};
    if (dims == 1) {
      comparison.suspects.push_back(
          {{std::sqrt(squared_deviations(values) / (size * r - 1) / (size * r))},
           "this is s / sqrt(n) over all points, as if they were independent"});
    }
    expect_each({got.call + ".standard_error", std::span(&bar, 1)}, comparison);
  }
}

CHECK_CASE("3.8 the error bar is honest for stratified points", "[3.8][points:1][needs:3.1]") {
  constexpr std::size_t n = 16, replicates = 9, times = 60;
  const experiments::Function g{1, (rng() % 2 == 0 ? 1 : -1) * uniform(rng, 0.5, 2),
                                uniform(rng, -1, 1), 0};
  const auto got = MEASURE(estimates_replicated, 1, g, 1, n, replicates, times, fresh_seed(rng));
  const auto& all = got.list_by_list({{times, finite}, {times * replicates * n, unit}});
  // Each estimate is recomputed from its points: plausible numbers alone do not pass.
  Values estimates;
  for (const ReplicatedEstimate& one : all.estimates) {
    require_work(got.call, one, n, replicates);
    Values means(replicates);
    for (std::size_t k = 0; k < n * replicates; ++k) {
      const double x = all.points[estimates.size() * n * replicates + k];
      means[k / n] += (g.a * std::exp(x) + g.b) / n;
    }
    const std::array pair{one.value, one.standard_error};
    expect_each({got.call + ", value and standard_error", pair},
                {.exact = {sum_of(means) / replicates, standard_error(means)},
                 .tolerance = {rounding},
                 .because = "both follow from the points of these replicates"});
    estimates.push_back(one.value);
  }
  const auto strata = strata_of(exponential, n);
  expect_variance({got.call, estimates, n * replicates}, g.a * mean_of(strata) + g.b,
                  g.a * g.a * stratified_variance(strata) / replicates, 3,
                  {"replicated estimates have 1/replicates of the exact variance", alpha},
                  {{}, "draw fresh points from the same generator for each replicate"});
}

std::vector<InvalidCall> nothing_to_average() {
  return {
      {MEASURE_OUTCOME(estimate_replicated, {1, 2}, 0, 1, 2), "n|point", "a mean needs a point"},
      {MEASURE_OUTCOME(estimate_replicated, {1, 2}, 2, 1, 0), "replicate",
       "a mean needs a replicate"}};
}

CHECK_CASE("3.8 one replicate has no error bar", "[3.8][edge][points:0.5]") {
  const auto one = MEASURE(estimate_replicated, uniform_values(rng, 10, -1, 1), 10, 1, 1);
  expect_nan(one.call + ".standard_error", one.value.standard_error,
             "one mean has no spread, so the result is undefined");
  expect_refused(nothing_to_average());
}

CHECK_CASE("3.8 the refusals name the argument", "[3.8][edge][points:0.5]") {
  expect_argument_named(nothing_to_average());
}

}  // namespace
}  // namespace mc::checks
