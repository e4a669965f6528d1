// The data of lab 4's plots and demo: patterns, their periodograms as pictures and as curves,
// the gain over independent points, and time against N. Cases of
// about equal cost.

#include <cmath>

#include "checks/support/catch.hpp"
#include "measurements/blue_noise/methods.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

const Names shown{"independent", "jittered", "few_candidates", "best_candidate", "poisson_disk"};

constexpr int kmax = 48, spectrum_side = 2 * kmax + 1;
constexpr std::size_t spectrum_size = spectrum_side * spectrum_side;

/// The mean periodogram of sets, by the submission; empty where it has none.
Values mean_periodogram(const Sets& sets) {
  Values mean;
  for (const PointSet& set : sets) {
    const auto x = set.column(0), y = set.column(1);
    const Values power =
        values_of(TRY_MEASURE(periodogram, {x.begin(), x.end()}, {y.begin(), y.end()}, 1, kmax),
                  spectrum_size);
    if (power.empty()) return {};
    mean.resize(spectrum_size);
    for (std::size_t i = 0; i < spectrum_size; ++i) {
      mean[i] += power[i] / static_cast<double>(sets.size());
    }
  }
  return mean;
}

TEST_CASE("plot patterns", "[.plot]") {
  plot_points("spectra-pattern", methods.of(shown), 256, 256);
}

TEST_CASE("plot periodograms as pictures and over rings", "[.plot]") {
  std::vector<Values> rings;  // of each method, from ring 0
  for (const std::string& key : shown) {
    Values mean = mean_periodogram(methods[key].points(256, 2, 40, 256));
    rings.emplace_back(kmax + 1, missing);
    if (!mean.empty()) {
      const auto got = TRY_MEASURE(radial_power, mean, kmax);
      rings.back() = lists_of(got, kmax + 1, any_number).value_or(rings.back());
    }
    mean.resize(spectrum_size, missing);
    plot_image("spectra-power-" + key + ".tsv", mean, spectrum_side);
  }
  Values frequencies;
  for (int ring = 1; ring <= kmax; ++ring) frequencies.push_back(ring / 16.);
  plot_table("radial.tsv", {"frequency", frequencies}, shown, [&](double x, std::size_t c) {
    const double power = rings[c][static_cast<std::size_t>(16 * x)];
    return std::isfinite(power) ? power : missing;
  });
}

/// The RMSE of n independent points, which is exact, divided by that of a method.
TEST_CASE("plot the gain over independent points", "[.plot]") {
  const std::vector<Integrand> both{integrand("bump"), integrand("edge")};
  const double mean = both[1].mean, variances[] = {both[0].variance, mean * (1 - mean)};
  const Names names{"jittered", "best_candidate", "poisson_disk"};
  Names columns{"N"};
  append(columns, names);
  auto smooth = plot_file("gain-bump.tsv", columns), edge = plot_file("gain-edge.tsv", columns);
  for (const double size : powers(4, 4, 65536)) {
    const auto n = static_cast<Count>(size);
    Values gains[2] = {{size}, {size}};
    for (const std::string& name : names) {
      const bool is_slow = name == "best_candidate";  // n^2 candidates
      const Count work = is_slow ? std::max(n, n * n / 64) : n;
      const Count sets = std::clamp<Count>((1u << 21) / work, 32, 400);
      const bool has = !(is_slow && n > 1024);
      const auto errors =
          has ? errors_of(methods[name], both, n, sets, n) : std::vector<ErrorSums>(2);
      for (std::size_t g = 0; g < 2; ++g) {
        gains[g].push_back(std::sqrt(variances[g] / size) / errors[g].rmse());
      }
    }
    plot_row(smooth, gains[0]);
    plot_row(edge, gains[1]);
  }
}

TEST_CASE("plot time against N", "[.plot][time]") {
  plot_table("speed.tsv", {"N", powers(64, 4, 65536)},
             methods.of({"best_candidate", "poisson_disk"}), [&](Count n, const Method& method) {
               if (method.key == "best_candidate" && n > 4096) return missing;  // n^2 candidates
               // Noise of a few per cent is nothing on four decades.
               return seconds_of(method.rounds_of(n, 2), 0.004) * 1e6 / static_cast<double>(n);
             });
}

TEST_CASE("demo", "[.demo]") {
  demo_points(4, methods.of({"best_candidate", "poisson_disk"}));
}

}  // namespace
}  // namespace mc::measurements
