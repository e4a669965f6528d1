// Lab 4 in the bench: figures that the handout quotes. Those of other ways than the solutions' are
// of mistakes: ten_candidates, bridson_alone.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "checks/blue_noise/point_sets.hpp"
#include "checks/support/catch.hpp"
#include "checks/support/discs.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::checks {
namespace {

/// A mean of independent values, and its standard error.
struct Mean {
  double count = 0, sum = 0, squares = 0, most = 0;
  void add(double value) {
    ++count;
    sum += value;
    squares += value * value;
    most = std::max(most, value);
  }
  double value() const { return sum / count; }
  double error() const {
    return std::sqrt(std::max(0.0, squares / count - value() * value()) / count);
  }
};

constexpr std::size_t low_n = 256, low_sets = 200;
constexpr int low_kmax = 8;  // sqrt(n) / 2

/// The mean power for 0 < |k| <= sqrt(n)/2.
void write_power(const std::string& row, double power, double error = nan) {
  bench_table({"low frequencies, N = 256", row, "power", 0, power, error});
}

Spectrum jittered_spectrum(int side) {
  Spectrum spectrum{low_kmax, {}};
  for (int ky = -low_kmax; ky <= low_kmax; ++ky) {
    for (int kx = -low_kmax; kx <= low_kmax; ++kx) {
      spectrum.power.push_back(jittered_power(kx, ky, side));
    }
  }
  return spectrum;
}

/// The radical inverses of 0, 1, … in a base, by Horner's rule: lab 5 need not be there.
Values halton_axis(unsigned base) {
  Values x(low_n);
  for (unsigned i = 1; i < low_n; ++i) {
    x[i] = (i % base + x[i / base]) / base;
  }
  return x;
}

TEST_CASE("bench table of low frequencies", "[.bench-table]") {
  write_power("independent, exact", 1);
  write_power("jittered, exact", low_band(jittered_spectrum(16), low_n));
  write_power("Halton, exact",
              low_band(spectrum_of(halton_axis(2), halton_axis(3), low_kmax), low_n));
  Mean power, closest;
  const auto points = TRY_MEASURE_WITH(large, best_candidate, low_n, 1, low_sets, 1);
  const Points* const all = points ? points->if_exactly(low_n * low_sets, unit) : nullptr;
  for (std::size_t set = 0; set < low_sets && all != nullptr; ++set) {
    const View x = View(all->x).subspan(set * low_n, low_n),
               y = View(all->y).subspan(set * low_n, low_n);
    power.add(low_band(spectrum_of(x, y, low_kmax), low_n));
    closest.add(least_distance(x, y) / lattice_distance(low_n));
  }
  if (all != nullptr) {
    write_power("best_candidate", power.value(), power.error());
    // In parts of the distance in the densest pattern.
    bench_table(
        {"closest two of 256", "best_candidate", "distance", 0, closest.value(), closest.error()});
  }
  Mean of_discs;
  const double radius = radius_for(low_n);
  const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, low_sets, 1);
  if (!got) return;
  for (const Set& set : patterns_if_any(*got, radius, low_sets)) {
    of_discs.add(low_band(spectrum_of(set.x, set.y, low_kmax), low_n));
  }
  if (of_discs.count > 0) write_power("poisson_disk", of_discs.value(), of_discs.error());
}

TEST_CASE("bench table of gaps", "[.bench-table]") {
  for (const double radius : {0.3, 0.63}) {
    constexpr std::size_t patterns = 4000;
    const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, patterns, 1);
    if (!got) return;
    Mean uncovered;
    for (const Set& set : patterns_if_any(*got, radius, patterns)) {
      uncovered.add(100 * uncovered_area(set.x, set.y, radius, 200));
    }
    if (uncovered.count == 0) return;
    const std::string title = "gaps, % of the square";
    const std::string row = fmt::format("radius {}", radius);
    bench_table({title, row, "mean", 0, uncovered.value(), uncovered.error()});
    bench_table({title, row, "the worst of 4000", 0, uncovered.most});
  }
}

/// How much less the RMSE is with 1,024 points, for exp(-x^2 - y^2), the plots' smooth integrand.
TEST_CASE("bench table of gains", "[.bench-table]") {
  constexpr double size = 1024;
  constexpr std::size_t patterns = 1000;
  const double radius = radius_for(size);
  const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, patterns, 1);
  if (!got) return;
  const auto integral = [](double a) {  // of exp(-a x^2) over [0, 1]
    return std::sqrt(std::numbers::pi / a) / 2 * std::erf(std::sqrt(a));
  };
  const double mean = std::pow(integral(1), 2);
  const double independent = std::sqrt((std::pow(integral(2), 2) - mean * mean) / size);
  ErrorSums errors;
  for (const Set& set : patterns_if_any(*got, radius, patterns)) {
    double sum = 0;
    for (std::size_t i = 0; i < set.x.size(); ++i) {
      sum += std::exp(-set.x[i] * set.x[i] - set.y[i] * set.y[i]);
    }
    errors.add(sum / static_cast<double>(set.x.size()) - mean);
  }
  if (errors.count == 0) return;
  const double ratio = independent / errors.rmse();
  bench_table({"gain over independent points", "poisson_disk", "ratio", 0, ratio,
               ratio * errors.standard_error() / errors.rmse()});
}

}  // namespace
}  // namespace mc::checks
