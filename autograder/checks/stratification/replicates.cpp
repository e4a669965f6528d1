// 3.8: estimates of replicates, and their error bars.

#include "checks/stratification/common.hpp"

namespace mc::checks {
namespace {

using experiments::ReplicatedEstimate;

/// A replicated mean of x0 + 2 x1 + …, and the values that its coordinates are taken from.
struct Dealt {
  std::size_t n, dims, replicates;
  Values values;

  /// The means of the replicates: of each, every column has its next n values.
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

Dealt deal(Rng& rng, std::size_t n, std::size_t dims, std::size_t replicates) {
  return {n, dims, replicates, uniform_values(rng, n * dims * replicates, -1, 1)};
}

double total_of(const Values& x) {
  return std::accumulate(x.begin(), x.end(), 0.0);
}

/// Sum of squared deviations from the mean.
double spread(const Values& x) {
  const double middle = total_of(x) / static_cast<double>(x.size());
  double squares = 0;
  for (const double value : x) squares += (value - middle) * (value - middle);
  return squares;
}

double standard_error(const Values& means) {
  const auto r = static_cast<double>(means.size());
  return std::sqrt(spread(means) / (r - 1) / r);
}

/// Sums of at most 10006 values of size one lose 10006 eps of them; 5e-12 is twice that.
constexpr double rounding = 5e-12;

/// Each replicate has its own set of n points, and g is evaluated once at each point.
void require_work(const std::string& call, const ReplicatedEstimate& got, std::size_t n,
                  std::size_t replicates) {
  const struct {
    const char* what;
    std::uint64_t count, expected;
    const char* hint;
  } counts[] = {
      {"calls of the generator", got.generated, replicates,
       "each replicate has its own point set, made in one call"},
      {"calls with a set that is not n x g.dims, or a point that is not", got.misshapen, 0,
       "the generator fills a PointSet(n, g.dims); g.f takes g.dims coordinates"},
      {"evaluations of the integrand", got.evaluated, n * replicates,
       "the integrand is what costs: once for each point"},
      {"Estimate.n", got.n, n * replicates, "Estimate.n counts evaluations: n * replicates"},
      {"calls of the generator with random numbers that it had before", got.repeated, 0,
       "replicates must be independent, and so must estimates: does each draw fresh points from "
       "the same generator, rng, and no copy of it?"}};
  for (const auto& [what, count, expected, hint] : counts) {
    expect_that(count == expected, fmt::format("{}: {} = {}", call, what, count),
                fmt::format("{}", expected), "", hint);
  }
}

CHECK_CASE("3.8 the estimate is the mean of the replicates", "[3.8][main][points:2]") {
  Rng rng = check_rng();
  auto late = deal(rng, 2, 1, 700);  // a rare event: means are constant before
  std::fill_n(late.values.begin(), 1302, 0.5);
  for (const auto& dealt :
       {deal(rng, 64, 1, 25), deal(rng, 7, 3, 3), deal(rng, 3, 9, 17), deal(rng, 5003, 1, 2),
        deal(rng, 2, 1, 1000), late, deal(rng, 100, 2, 1), deal(rng, 1, 1, 2)}) {
    const auto [n, dims, replicates, values] = dealt;
    const auto got = MEASURE(estimate_replicated, values, n, dims, replicates);
    require_work(got.call, got.value, n, replicates);
    const Values means = dealt.means();
    const auto r = static_cast<double>(replicates), size = static_cast<double>(n);
    const double exact = total_of(means) / r, value = got.value.value;
    expect_each({got.call + ".value", std::span(&value, 1)},
                {.exact = {exact},
                 .tolerance = {rounding},
                 .because = "the mean of all values",
                 .suspects = {{{exact * size * r}, "this is the sum: divide it by n * replicates"},
                              {{exact * r}, "this is the sum of the replicates' means"},
                              {{exact * size}, "divide by n too"},
                              {{means.back()}, "this is the mean of the last replicate"},
                              {{means.front()}, "this is the mean of the first replicate"}},
                 .otherwise = "every point of every replicate counts once",
                 .is_tame = true});
  }
  for (const double odd : {domain::infinity, -domain::infinity, domain::not_a_number}) {
    const auto got = MEASURE(estimate_replicated, {0, 1, 0, 2, odd, 1, 0, 1, 0, 1}, 2, 1, 5);
    require_work(got.call, got.value, 2, 5);
    expect_that(!std::isfinite(got.value.value), fmt::format("{} = {}", got.call, got.value.value),
                "no finite value", "",
                "a mean that is infinite or NaN counts, too: do not drop it");
  }
}

CHECK_CASE("3.8 the error bar is the spread of the replicates", "[3.8][points:2]") {
  Rng rng = check_rng();
  // At an offset of 1e6 the means have 52 - 20 bits after the point: 1e-9 of their spread. The
  // textbook's formula has 1e6^2 eps = 1e-4 left.
  for (auto dealt : {deal(rng, 7, 1, 5), deal(rng, 64, 2, 25), deal(rng, 5, 1, 3),
                     deal(rng, 2, 1, 1000), deal(rng, 1, 1, 2), deal(rng, 8, 1, 20)}) {
    const bool is_far = dealt.replicates == 20;
    for (double& value : dealt.values) value += is_far ? 1e6 : 0;
    const auto [n, dims, replicates, values] = dealt;
    const Values means = dealt.means();
    const auto r = static_cast<double>(replicates), size = static_cast<double>(n);
    const double exact = standard_error(means);
    const auto got = MEASURE(estimate_replicated, values, n, dims, replicates);
    const double bar = got.value.standard_error;
    Comparison comparison{
        .exact = {exact},
        .tolerance = {is_far ? 1e-7 * exact : rounding},
        .because =
            "s / sqrt(replicates), with s the sample standard deviation of the replicates' "
            "means",
        .suspects = {{{exact * std::sqrt(r)},
                      "this is the standard deviation of one mean: divide it by sqrt(replicates)"},
                     {{std::sqrt(spread(means)) / r},
                      "this divides by replicates; a sample variance divides by replicates - 1"},
                     {{exact / std::sqrt(size)},
                      "this divides by sqrt(n * replicates): divide by sqrt(replicates), the "
                      "number of means"},
                     {{exact * exact}, "this is the variance of the estimate: take its root"}},
        .otherwise = is_far
                         ? "E{X^2} - E{X}^2 cancels: compute the variance of the means with lab 1"
                         : "the replicates' means are independent of each other: compute "
                           "their variance with lab 1",
        .is_tame = !is_far};
    if (dims == 1) {
      comparison.suspects.push_back(
          {{std::sqrt(spread(values) / (size * r - 1) / (size * r))},
           "this is s / sqrt(n) over all points, as if they were independent: only the "
           "replicates' means are"});
    }
    expect_each({got.call + ".standard_error", std::span(&bar, 1)}, comparison);
  }
}

CHECK_CASE("3.8 the error bar is honest for stratified points", "[3.8][points:1][needs:3.1]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 16, replicates = 9, times = 60;
  const experiments::Function g{1, (rng() % 2 == 0 ? 1 : -1) * uniform(rng, 0.5, 2),
                                uniform(rng, -1, 1), 0};
  const auto got = MEASURE(estimates_replicated, 1, g, 1, n, replicates, times, fresh_seed(rng));
  const auto& all = got.list_by_list({{times, finite}, {times * replicates * n, unit}});
  // An estimate comes of the points that were made for it: numbers that only look so cost no work.
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
                {.exact = {total_of(means) / replicates, standard_error(means)},
                 .tolerance = {rounding},
                 .because = "they are computed from the points of these replicates"});
    estimates.push_back(one.value);
  }
  const auto strata = strata_of(exponential, n);
  expect_variance({got.call, estimates, n * replicates}, g.a * mean_of(strata) + g.b,
                  g.a * g.a * stratified_variance(strata) / replicates, 3,
                  {"replicated estimates have 1/replicates of the exact variance", alpha},
                  {{}, "does each replicate draw fresh points from the same generator?"});
}

std::vector<InvalidCall> nothing_to_average() {
  return {
      {MEASURE_OUTCOME(estimate_replicated, {1, 2}, 0, 1, 2), "n|point", "a mean needs a point"},
      {MEASURE_OUTCOME(estimate_replicated, {1, 2}, 2, 1, 0), "replicate",
       "a mean needs a replicate"}};
}

CHECK_CASE("3.8 one replicate has no error bar", "[3.8][edge][points:0.5]") {
  Rng rng = check_rng();
  const auto one = MEASURE(estimate_replicated, uniform_values(rng, 10, -1, 1), 10, 1, 1);
  expect_nan(one.call + ".standard_error", one.value.standard_error,
             "one mean has no spread; what is undefined is NaN");
  expect_refused(nothing_to_average());
}

CHECK_CASE("3.8 the refusals name the argument", "[3.8][edge][points:0.5]") {
  expect_argument_named(nothing_to_average());
}

}  // namespace
}  // namespace mc::checks
