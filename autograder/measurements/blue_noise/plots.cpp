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
std::vector<double> mean_periodogram(Sets sets) {
  std::vector<double> mean;
  const auto values = static_cast<std::size_t>(spectrum_side * spectrum_side);
  std::stable_sort(sets.begin(), sets.end(),
                   [](const PointSet& a, const PointSet& b) { return a.size() < b.size(); });
  for (std::size_t first = 0, end; first < sets.size(); first = end) {
    std::vector<double> x, y;
    for (end = first; end < sets.size() && sets[end].size() == sets[first].size(); ++end) {
      x.insert(x.end(), sets[end].column(0).begin(), sets[end].column(0).end());
      y.insert(y.end(), sets[end].column(1).begin(), sets[end].column(1).end());
    }
    const auto power =
        lists_of(TRY_MEASURE(periodogram, x, y, end - first, kmax), (end - first) * values);
    if (!power) return {};
    mean.resize(values);
    for (std::size_t i = 0; i < power->size(); ++i) {
      mean[i % values] += (*power)[i] / static_cast<double>(sets.size());
    }
  }
  return mean;
}

TEST_CASE("plot patterns", "[.plot]") {
  for (const std::string& key : shown) {
    plot_points("spectra-pattern-" + key + ".tsv", method(methods, key).points(256, 2, 1, 256));
  }
}

TEST_CASE("plot periodograms as pictures and over rings", "[.plot]") {
  Names columns{"frequency"};
  std::vector<Row> rows(kmax);
  for (std::size_t ring = 1; ring <= kmax; ++ring) {
    rows[ring - 1].emplace_back(static_cast<double>(ring) / 16);
  }
  for (const std::string& key : shown) {
    const auto mean = mean_periodogram(method(methods, key).points(256, 2, 40, 256));
    auto file = plot_file("spectra-power-" + key + ".tsv");
    for (std::size_t row = 0; row < spectrum_side; ++row) {
      Row values(spectrum_side);
      for (std::size_t i = 0; i < values.size() && !mean.empty(); ++i) {
        values[i] = mean[row * spectrum_side + i];
      }
      plot_row(file, values);
    }
    columns.push_back(key);
    for (Row& row : rows) row.emplace_back();
    if (mean.empty()) continue;
    const auto rings = lists_of(TRY_MEASURE(radial_power, mean, kmax), kmax + 1, any_number);
    for (std::size_t ring = 1; rings && ring <= kmax; ++ring) {
      if (std::isfinite((*rings)[ring])) rows[ring - 1].back() = (*rings)[ring];
    }
  }
  auto file = plot_file("radial.tsv", columns);
  for (const Row& row : rows) plot_row(file, row);
}

TEST_CASE("plot error against N", "[.plot]") {
  plot_errors(
      {.names = {"bump", "edge"},
       .integrands = {integrand("bump"), integrand("edge")},
       .methods =
           methods_of(methods, {"independent", "jittered", "best_candidate", "poisson_disk"}),
       .sizes = {4, 16, 64, 256, 1024},
       .replicates = [](std::uint64_t n) -> std::uint64_t { return n == 1024 ? 40 : 100; }});
}

TEST_CASE("plot time against N", "[.plot]") {
  const Names keys{"best_candidate", "poisson_disk"};
  plot_table(
      "speed.tsv", {"N", powers(64, 4, 65536)}, keys, [&](double n, std::size_t c) -> Number {
        if (c == 0 && n > 4096) return {};  // it takes n^2 candidates
        // Noise of a few per cent is nothing on four decades.
        const Number round = seconds_of(
            [&](std::uint64_t rounds) {
              return method(methods, keys[c]).rounds(static_cast<std::uint64_t>(n), 2, rounds);
            },
            0.004);
        return round ? Number(*round * 1e6 / n) : Number{};
      });
}

TEST_CASE("demo", "[.demo]") {
  begin_demo();
  for (const char* key : {"best_candidate", "poisson_disk"}) {
    write_demo_points(4, method(methods, key));
  }
}

}  // namespace
}  // namespace mc::measurements
