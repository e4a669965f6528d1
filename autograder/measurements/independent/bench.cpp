// Lab 2 in the bench: independent points, and irradiance two ways; and numbers that
// the handout quotes.

#include <cmath>
#include <numbers>

#include "checks/support/catch.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/independent/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors({uniform_points});
  for (const unsigned way : {0u, 1u}) {
    for (Count n = 16; n <= 65536; n *= 4) {
      bench_error(light_ways[way], "rectangular light", 2, n, irradiance_errors(way, n, 200, n),
                  irradiance(RectLight{}));
    }
  }
}

TEST_CASE("bench time", "[.bench-time]") {
  bench_times({uniform_points});
  for (const unsigned way : {0u, 1u}) {
    bench_time(light_ways[way], "", 2, 4096, irradiance_rounds(way));
  }
}

TEST_CASE("bench growth", "[.bench-growth]") {
  bench_growth_of_dims(uniform_points);
  bench_growth(uniform_points, 1, 100'000'000);
}

/// The sixty estimates of the picture of intervals, by its seed.
TEST_CASE("bench table of intervals", "[.bench-table]") {
  const BenchTable table("95 % intervals that miss, of 60");
  const double z = normal_quantile(0.975);
  for (const std::size_t i : {0u, 4u}) {
    const auto all = estimates_of(line_integrands[i], 1000, 60);
    if (all.empty()) return;
    double misses = 0;
    for (const auto& one : all) {
      misses += std::abs(one.value - line_integrands[i].mean) > z * one.standard_error;
    }
    table.add(line_integrands[i].name, "misses", misses);
  }
}

/// The outcome of a run that goes on until its error bar is short enough.
struct Stopped {
  double value = 0, covered = 0, again = 0, pooled = 0, samples = 0;
};

/// x < p, looked at after every 32 samples, until s / sqrt(n) <= target. Exact: the probability of
/// every number of hits. `again` is the coverage of a second run with as many samples, `pooled`
/// that of a run that stops by the s of many runs together, the true one.
Stopped stopped_run(double p, double target) {
  constexpr std::size_t step = 32;
  const auto grown = [=](const std::vector<double>& odds) {
    std::vector<double> more = odds;
    more.push_back(0);
    for (std::size_t k = more.size(); k-- > 0;) {
      more[k] = more[k] * (1 - p) + (k > 0 ? more[k - 1] * p : 0);
    }
    return more;
  };
  Stopped all;
  std::vector<double> going{1}, fresh{1};  // by hits: runs that still go on; and all runs
  for (std::size_t n = step; going.size() < 8192; n += step) {
    for (std::size_t i = 0; i < step; ++i) going = grown(going), fresh = grown(fresh);
    const auto size = static_cast<double>(n);
    double stops = 0, covers = 0, covers_pooled = 0;
    const double pooled_bar = std::sqrt(p * (1 - p) / size), z = normal_quantile(0.975);
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
    if (std::accumulate(going.begin(), going.end(), 0.0) < 1e-12) break;
  }
  return all;
}

/// What is computed here is the same for all: it is shown with a submission of 2.7.
bool has_lights() {
  return irradiance_errors(0, 16, 2, 1).count > 0;
}

TEST_CASE("bench table of stopping", "[.bench-table]") {
  if (!has_lights()) return;
  const BenchTable table("x < 0.02, stopped when the error bar is short enough");
  const double p = 0.02;
  for (const auto& [row, target] : {std::pair{"s / sqrt(n) <= 0.01", 0.01},
                                    {"s / sqrt(n) <= 0.005", 0.005},
                                    {"s / sqrt(n) <= 0.002", 0.002}}) {
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
  const BenchTable one_sample("variance of a sample of a light at height 1");
  const BenchTable two_samples("relative variance of two samples of a light at height 1");
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
    const double mean = irradiance(light);
    const double points = over_light([](double f, double p, double) { return f * f / p; }),
                 directions = over_light([](double f, double, double q) { return f * f / q; });
    const double both = over_light([](double f, double p, double q) { return f * f / (p + q); }),
                 by_points =
                     over_light([](double f, double p, double q) { return f * p / (p + q); });
    one_sample.add("points", name, points - mean * mean);
    one_sample.add("directions", name, directions - mean * mean);
    const auto relative = [&](double square) { return square / mean / mean; };
    two_samples.add("two points", name, (relative(points) - 1) / 2);
    two_samples.add("two directions", name, (relative(directions) - 1) / 2);
    two_samples.add("the average of one and one", name, (relative(points + directions) - 2) / 4);
    two_samples.add("one and one, balanced", name,
                    relative(both - by_points * by_points - std::pow(mean - by_points, 2)));
  }
}

}  // namespace
}  // namespace mc::measurements
