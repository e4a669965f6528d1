// 3.8: estimates of replicates, and their error bars.

#include <cmath>
#include <numeric>

#include "checks/stratification/levels.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/data.hpp"
#include "checks/support/refusals.hpp"

namespace mc::checks {
namespace {

using experiments::Replicated;

/// A replicated mean of x0 + 2 x1 + …, and the values that its coordinates are dealt from.
struct Dealt {
  std::size_t n, dims, replicates;
  Values values;

  /// The mean of one replicate, of which each column has its next n values.
  double mean_of(std::size_t replicate) const {
    double sum = 0;
    for (std::size_t d = 0; d < dims; ++d) {
      for (std::size_t k = 0; k < n; ++k) {
        sum += static_cast<double>(d + 1) * values[(replicate * dims + d) * n + k];
      }
    }
    return sum / static_cast<double>(n);
  }
};

Dealt deal(Rng& rng, std::size_t n, std::size_t dims, std::size_t replicates) {
  return {n, dims, replicates, uniform_values(rng, n * dims * replicates, -1, 1)};
}

double mean(const Values& x) {
  return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

/// Sum of squared deviations from the mean.
double spread(const Values& x) {
  const double middle = mean(x);
  double sum = 0;
  for (const double value : x) sum += (value - middle) * (value - middle);
  return sum;
}

/// Sums of at most 6000 values of size one lose 6000 eps of them; 5e-12 is four times that.
constexpr double rounding = 5e-12;

CHECK_CASE("3.8 the estimate is the mean of the replicates", "[3.8][main][points:2]") {
  Rng rng = check_rng();
  for (const auto& dealt :
       {deal(rng, 64, 1, 25), deal(rng, 7, 3, 3), deal(rng, 100, 2, 1), deal(rng, 1, 1, 2)}) {
    const auto [n, dims, replicates, values] = dealt;
    const auto got = MEASURE(estimate_replicated, values, n, dims, replicates);
    const Replicated& value = got.value;
    const auto expect_count = [&](const char* what, std::uint64_t counted, std::uint64_t expected,
                                  const std::string& hint) {
      expect_that(counted == expected, fmt::format("{}: {} = {}", got.call, what, counted),
                  fmt::format("{}", expected), "", hint);
    };
    expect_count("calls of the generator", value.generated, replicates,
                 "each replicate has a point set of its own, made in one call");
    expect_count("calls with a set that is not n x g.dims, or a point that is not", value.misshapen,
                 0, "the generator fills a PointSet(n, g.dims); g.f takes g.dims coordinates");
    expect_count("evaluations of the integrand", value.evaluated, n * replicates,
                 "the integrand is what costs: once for each point");
    double sum = 0;
    for (std::size_t k = 0; k < replicates; ++k) sum += dealt.mean_of(k);
    const double exact = sum / static_cast<double>(replicates);
    expect_within(got.call + ".value", value.value, exact, rounding, "the mean of all values",
                  {{{exact * static_cast<double>(n * replicates),
                     "this is the sum: divide it by n * replicates"},
                    {sum, "this is the sum of the replicates' means"},
                    {exact * static_cast<double>(n), "divide by n too"},
                    {dealt.mean_of(replicates - 1), "this is the mean of the last replicate"},
                    {dealt.mean_of(0), "this is the mean of the first replicate"}},
                   "every point of every replicate counts once"});
    expect_count("Estimate.n", value.n, n * replicates,
                 "Estimate.n counts evaluations: n * replicates");
    expect_count("calls of the generator with random numbers that it had before", value.repeated, 0,
                 "replicates must be independent: does each draw fresh points from the same "
                 "generator?");
  }
}

CHECK_CASE("3.8 the error bar is the spread of the replicates", "[3.8][points:2]") {
  Rng rng = check_rng();
  for (const auto& dealt :
       {deal(rng, 7, 1, 5), deal(rng, 64, 2, 25), deal(rng, 5, 1, 3), deal(rng, 1, 1, 2)}) {
    const auto [n, dims, replicates, values] = dealt;
    const auto r = static_cast<double>(replicates), size = static_cast<double>(n);
    Values means;
    for (std::size_t k = 0; k < replicates; ++k) means.push_back(dealt.mean_of(k));
    const double among = spread(means), exact = std::sqrt(among / (r - 1) / r);
    const double all_apart =  // of the values themselves, where one is a point
        dims == 1 ? std::sqrt(spread(values) / (size * r - 1) / (size * r)) : -1;
    const auto got = MEASURE(estimate_replicated, values, n, dims, replicates);
    expect_within(
        got.call + ".standard_error", got.value.standard_error, exact, rounding,
        "s / sqrt(replicates), with s the sample standard deviation of the replicates' means",
        {{{all_apart,
           "this is s / sqrt(n) over all points, as if they were independent: only the replicates' "
           "means are"},
          {std::sqrt(among / (r - 1)),
           "this is the standard deviation of one mean: divide it by sqrt(replicates)"},
          {std::sqrt(among) / r,
           "this divides by replicates; a sample variance divides by "
           "replicates - 1"},
          {exact / std::sqrt(size),
           "this divides by sqrt(n * replicates): divide by sqrt(replicates), the number of means"},
          {among / (r - 1) / r, "this is the variance of the estimate: take its root"}},
         "the replicates' means are independent of each other: lab 1 knows their variance"});
  }
  // At an offset of 1e6 the means have 52 - 20 bits behind the point: 1e-9 of their spread. The
  // textbook's formula has 1e6^2 eps = 1e-4 left.
  Dealt far = deal(rng, 8, 1, 20);
  for (double& value : far.values) value += 1e6;
  Values means;
  for (std::size_t k = 0; k < far.replicates; ++k) means.push_back(far.mean_of(k));
  const auto got = MEASURE(estimate_replicated, far.values, far.n, far.dims, far.replicates);
  const double exact = std::sqrt(spread(means) / 19 / 20);
  expect_within(got.call + ".standard_error", got.value.standard_error, exact, 1e-7 * exact,
                "lab 1: deviations from the mean keep their digits where values are large",
                {{}, "E{X^2} - E{X}^2 cancels: let lab 1 tell the variance of the means"});
}

/// An estimate comes of the points that were made for it, and its bar of how their means differ:
/// numbers that only look so cost no work. Whether the bar has the right factor is for the exact
/// check: one of 8/9 passes here, one that is drawn from its distribution (9 replicates: 25 %)
/// never does 60 times.
void expect_of_its_points(const std::string& call, const Replicated& got,
                          const experiments::Function& g, View points, std::size_t n) {
  Values means;
  for (std::size_t first = 0; first < points.size(); first += n) {
    double sum = 0;
    for (const double x : points.subspan(first, n)) sum += g.a * std::exp(x) + g.b;
    means.push_back(sum / static_cast<double>(n));
  }
  const auto r = static_cast<double>(means.size());
  expect_that(
      got.generated == means.size() && got.evaluated == points.size(),
      fmt::format("{}: {} sets of points and {} evaluations for an estimate", call, got.generated,
                  got.evaluated),
      fmt::format("{} and {}", means.size(), points.size()), "",
      "each replicate has a point set of its own, and g is evaluated at each of its points");
  expect_within(call + ".value", got.value, mean(means), rounding, "the mean of its points",
                {{}, "every point of every replicate counts once"});
  const double bar = std::sqrt(spread(means) / (r - 1) / r);
  expect_within(call + ".standard_error", got.standard_error, bar, 0.3 * bar,
                "s / sqrt(replicates), within 30 %",
                {{}, "the error bar comes from the spread of the means of these replicates"});
}

CHECK_CASE("3.8 the error bar is honest for stratified points", "[3.8][points:1][needs:3.1]") {
  Rng rng = check_rng();
  constexpr std::size_t n = 16, replicates = 9, times = 60;
  const experiments::Function g{1, (rng() % 2 == 0 ? 1 : -1) * uniform(rng, 0.5, 2),
                                uniform(rng, -1, 1), 0};
  const auto strata = strata_of(exponential, n);
  const double exact = g.a * mc::checks::mean_of(strata) + g.b;
  const double variance = g.a * g.a * stratified_variance(strata) / replicates;
  const auto got = MEASURE(estimates_replicated, 1, g, 1, n, replicates, times, fresh_seed(rng));
  const auto& all = got.list_by_list({{times, finite}, {times * replicates * n, unit}});
  Values estimates, bars;
  for (const Replicated& one : all.estimates) {
    const View points = View(all.points).subspan(estimates.size() * replicates * n, replicates * n);
    expect_of_its_points(got.call, one, g, points, n);
    estimates.push_back(one.value);
    bars.push_back(one.standard_error);
  }
  // 60 bars tell a factor of 2; one of 8/9 is for the exact check before.
  const std::string fresh = "does each replicate draw fresh points from the same generator?";
  expect_variance({got.call, estimates, n * replicates}, exact, variance, 3,
                  {"replicated estimates have 1/replicates of the exact variance", alpha},
                  {{{replicates, "all replicates are the same points: " + fresh}}, fresh});
  // A squared bar is chi-squared with replicates - 1 degrees of freedom, which is what a kurtosis
  // of 1 + 2 / (replicates - 1) stands for.
  expect_variance({got.call + ".standard_error", bars, n * replicates}, 0, variance,
                  1 + 2.0 / (replicates - 1),
                  {"squared error bars are the exact variance on average", alpha}, {{}, fresh});
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
