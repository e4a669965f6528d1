// Lab 2 in the bench: irradiance two ways; and numbers that the handout quotes.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "checks/support/exact.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/independent/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench error of lights", "[.bench-error]") {
  for (const LightWay& way : light_ways) {
    for (Count n = 16; n <= 65536; n *= 4) {
      bench_error(way.name, "rectangular light", 2, n, way.errors(n, 200, n),
                  irradiance(RectLight{}));
    }
  }
}

TEST_CASE("bench time of lights", "[.bench-time]") {
  for (const LightWay& way : light_ways) bench_time(way.name, "", 2, 4096, way.rounds());
}

TEST_CASE("bench growth", "[.bench-growth]") {
  bench_growth_of_dims(methods.front());
  bench_growth(methods.front(), 1, 100'000'000);
}

/// The sixty estimates of the picture of intervals, by its seed.
TEST_CASE("bench table of intervals", "[.bench-table]") {
  const double z = normal_quantile(0.975);
  for (const std::size_t i : {0u, 4u}) {
    const auto& [name, g, mean] = line_integrands[i];
    const auto all = estimates_of(line_integrands[i], 1000, 60);
    if (all.empty()) return;
    const auto misses = std::count_if(all.begin(), all.end(), [&, exact = mean](const auto& one) {
      return std::abs(one.value - exact) > z * one.standard_error;
    });
    BenchTable{"95 % intervals that miss, of 60"}.add(name, "misses", static_cast<double>(misses));
  }
}

/// The outcome of a run that goes on until its error bar is short enough.
struct Stopped {
  double value = 0, covered = 0, again = 0, pooled = 0, samples = 0;
};

/// One more sample x < p: `odds` are the probabilities of every number of hits.
void grow(std::vector<double>& odds, double p) {
  odds.push_back(0);
  for (std::size_t k = odds.size(); k-- > 0;) {
    odds[k] = odds[k] * (1 - p) + (k > 0 ? odds[k - 1] * p : 0);
  }
}

/// x < p, looked at after every 32 samples, until s / sqrt(n) <= target. Exact: the probability of
/// every number of hits. `again` is the coverage of a second run with as many samples, `pooled`
/// that of a run that stops by the s of many runs together, the true one.
Stopped stopped_run(double p, double target) {
  const double z = normal_quantile(0.975);
  Stopped all;
  std::vector<double> going{1}, fresh{1};  // by hits: runs that still go on; and all runs
  for (std::size_t n = 1; sum_of(going) >= 1e-12; ++n) {
    grow(going, p);
    grow(fresh, p);
    if (n % 32 != 0) continue;
    const auto size = static_cast<double>(n);
    double stops = 0, covers = 0, covers_pooled = 0;
    const double pooled_bar = std::sqrt(p * (1 - p) / size);
    for (std::size_t k = 0; k <= n; ++k) {
      const double share = static_cast<double>(k) / size;
      const double bar = std::sqrt(share * (1 - share) / (size - 1));
      const bool is_covered = std::abs(share - p) <= z * bar;
      covers_pooled += std::abs(share - p) <= z * pooled_bar ? fresh[k] : 0;
      covers += is_covered ? fresh[k] : 0;
      if (bar > target) continue;
      stops += going[k];
      all.value += going[k] * share;
      all.covered += is_covered ? going[k] : 0;
      all.samples += going[k] * size;
      going[k] = 0;
    }
    all.again += stops * covers;
    if (pooled_bar <= target && all.pooled == 0) all.pooled = covers_pooled;
  }
  return all;
}

/// What is computed here is the same for all: it is shown with a submission of 2.7.
bool has_lights() {
  return light_ways[0].errors(16, 2, 1).count() > 0;
}

TEST_CASE("bench table of stopping", "[.bench-table]") {
  if (!has_lights()) return;
  const BenchTable table{"x < 0.02, stopped when the error bar is short enough"};
  const double p = 0.02;
  for (const double target : {0.01, 0.005, 0.002}) {
    const std::string row = fmt::format("s / sqrt(n) <= {}", target);
    const Stopped run = stopped_run(p, target);
    table.add(row, "mean by the true value", run.value / p);
    table.add(row, "coverage", run.covered);
    table.add(row, "of a second run", run.again);
    table.add(row, "of pooled s", run.pooled);
    table.add(row, "samples", run.samples);
  }
}

/// Variances of a sample of 2.7, and relative ones of two samples: two points, two directions, one
/// of each, with weights f / p, or by the balance heuristic f / (p + q).
TEST_CASE("bench table of lights", "[.bench-table]") {
  if (!has_lights()) return;
  const BenchTable one_sample{"variance of a sample of a light at height 1"};
  const BenchTable two_samples{"relative variance of two samples of a light at height 1"};
  for (const auto& [name, light] :
       {std::pair<const char*, RectLight>{"a lamp, half a side 0.33", {-0.33, 0.33, -0.33, 0.33}},
        {"the light of 2.7", {}},
        {"half a side 2", {-2, 2, -2, 2}},
        {"a ceiling, half a side 10", {-10, 10, -10, 10}}}) {
    // Over the directions to the light: of f, and of the densities p of points and q of directions.
    const auto over_light = [&, one = light](auto integrand) {
      return integral_over(one, [&](double x, double y) {
        const double r2 = x * x + y * y + 1, f = 1 / std::sqrt(r2);
        return integrand(f, r2 / (area(one) * f), f / std::numbers::pi) * f / r2;
      });
    };
    const double mean = irradiance(light), square = mean * mean;
    const double points = over_light([](double f, double p, double) { return f * f / p; });
    const double directions = over_light([](double f, double, double q) { return f * f / q; });
    const double both = over_light([](double f, double p, double q) { return f * f / (p + q); });
    const double by_points =
        over_light([](double f, double p, double q) { return f * p / (p + q); });
    const double balanced = both - by_points * by_points - std::pow(mean - by_points, 2);
    one_sample.add("points", name, points - square);
    one_sample.add("directions", name, directions - square);
    two_samples.add("two points", name, (points / square - 1) / 2);
    two_samples.add("two directions", name, (directions / square - 1) / 2);
    two_samples.add("the average of one and one", name, ((points + directions) / square - 2) / 4);
    two_samples.add("one and one, balanced", name, balanced / square);
  }
}

}  // namespace
}  // namespace mc::measurements
