// The data of lab 4's plots and demo: patterns, their periodograms as pictures and as curves,
// errors of integration next to those of random and jittered points, and time against N. Cases of
// about equal cost.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/blue_noise/methods.hpp"
#include "measurements/support/demo.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

const Names shown{"independent", "jittered", "few_candidates", "best_candidate", "poisson_disk"};

TEST_CASE("plot names", "[.plot]") {
  plot_names(methods);
}

constexpr int kmax = 48, spectrum_side = 2 * kmax + 1;

/// The mean periodogram of sets, by the submission; empty where it has none. Sets of one size go
/// together.
Values mean_periodogram(Sets sets) {
  Values mean;
  const auto values = static_cast<std::size_t>(spectrum_side * spectrum_side);
  std::stable_sort(sets.begin(), sets.end(),
                   [](const PointSet& a, const PointSet& b) { return a.size() < b.size(); });
  for (std::size_t first = 0, end; first < sets.size(); first = end) {
    Values x, y;
    for (end = first; end < sets.size() && sets[end].size() == sets[first].size(); ++end) {
      x.insert(x.end(), sets[end].column(0).begin(), sets[end].column(0).end());
      y.insert(y.end(), sets[end].column(1).begin(), sets[end].column(1).end());
    }
    const Values power =
        values_of(TRY_MEASURE(periodogram, x, y, end - first, kmax), (end - first) * values);
    if (power.empty()) return {};
    mean.resize(values);
    for (std::size_t i = 0; i < power.size(); ++i) {
      mean[i % values] += power[i] / static_cast<double>(sets.size());
    }
  }
  return mean;
}

TEST_CASE("plot patterns", "[.plot]") {
  plot_points("spectra-pattern", methods_of(methods, shown), 256, 256);
}

TEST_CASE("plot periodograms as pictures and over rings", "[.plot]") {
  std::vector<Values> rings;  // of each method, from ring 0
  for (const std::string& key : shown) {
    Values mean = mean_periodogram(method(methods, key).points(256, 2, 40, 256));
    rings.emplace_back(kmax + 1, missing);
    if (!mean.empty()) {
      const auto got = TRY_MEASURE(radial_power, mean, kmax);
      rings.back() = lists_of(got, kmax + 1, any_number).value_or(rings.back());
    }
    mean.resize(spectrum_side * spectrum_side, missing);
    plot_image("spectra-power-" + key + ".tsv", mean, spectrum_side);
  }
  Values frequencies;
  for (int ring = 1; ring <= kmax; ++ring) frequencies.push_back(ring / 16.);
  plot_table("radial.tsv", {"frequency", frequencies}, shown, [&](double x, std::size_t c) {
    const double power = rings[c][static_cast<std::size_t>(16 * x)];
    return std::isfinite(power) ? power : missing;
  });
}

TEST_CASE("plot error against N", "[.plot]") {
  plot_errors({.names = {"bump", "edge"},
               .integrands = {integrand("bump"), integrand("edge")},
               .methods = methods_of(methods,
                                     {"independent", "jittered", "best_candidate", "poisson_disk"}),
               .sizes = {4, 16, 64, 256, 1024},
               .replicates = [](Count n) -> Count { return n == 1024 ? 40 : 100; }});
}

TEST_CASE("plot time against N", "[.plot]") {
  plot_table("speed.tsv", {"N", powers(64, 4, 65536)},
             methods_of(methods, {"best_candidate", "poisson_disk"}),
             [&](Count n, const Method& method) {
               if (method.key == "best_candidate" && n > 4096) return missing;  // n^2 candidates
               // Noise of a few per cent is nothing on four decades.
               return seconds_of(method.rounds_of(n, 2), 0.004) * 1e6 / static_cast<double>(n);
             });
}

TEST_CASE("demo", "[.demo]") {
  demo_points(4, methods_of(methods, {"best_candidate", "poisson_disk"}));
}

}  // namespace
}  // namespace mc::measurements
