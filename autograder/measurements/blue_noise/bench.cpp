// Lab 4 in the bench: growth, and numbers that the handout quotes. Those of other ways than the
// solutions' are of mistakes: ten_candidates, bridson_alone.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "checks/support/disks.hpp"
#include "measurements/blue_noise/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

TEST_CASE("bench growth", "[.bench-growth]") {
  bench_growth(methods["best_candidate"], 2, 4096, 256, 4);
  bench_growth(methods["poisson_disk"], 2, 65536, 256, 4);
}

constexpr std::size_t low_n = 256, low_sets = 200;
constexpr int low_kmax = 8;  // sqrt(n) / 2

/// The mean power for 0 < |k| <= sqrt(n)/2.
double power_of(View x, View y) {
  return low_band(spectrum_of(x, y, low_kmax), low_n);
}

/// The same of jittered points, one in each of 16 x 16 cells. At k it is 1 - sinc(kx / 16)^2
/// sinc(ky / 16)^2 on average: a cell's mean wave has the size sinc sinc; what cells have in common
/// cancels, each cell's own remainder does not.
double power_of_jittered() {
  const auto sinc = [](int k) {
    const double turn = std::numbers::pi * k / 16;
    return k == 0 ? 1 : std::sin(turn) / turn;
  };
  Spectrum spectrum{low_kmax, {}};
  for (int ky = -low_kmax; ky <= low_kmax; ++ky) {
    for (int kx = -low_kmax; kx <= low_kmax; ++kx) {
      spectrum.power.push_back(1 - std::pow(sinc(kx) * sinc(ky), 2));
    }
  }
  return low_band(spectrum, low_n);
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
  const BenchTable table{"low frequencies, N = 256"};
  table.add("independent, exact", "power", 1);
  table.add("jittered, exact", "power", power_of_jittered());
  table.add("Halton, exact", "power", power_of(halton_axis(2), halton_axis(3)));
  for (const Method& one : methods.of({"best_candidate", "poisson_disk"})) {
    ErrorSums power, closest;  // distances are parts of that in the densest pattern
    for (const PointSet& set : one.points(low_n, 2, low_sets, 1)) {
      power.add(power_of(set.column(0), set.column(1)));
      closest.add(least_distance(set.column(0), set.column(1)) / lattice_distance(low_n));
    }
    table.add_mean(one.key, "power", power);
    if (one.key == "best_candidate") {
      BenchTable{"closest two of 256"}.add_mean(one.key, "distance", closest);
    }
  }
}

TEST_CASE("bench table of gaps", "[.bench-table]") {
  const BenchTable table{"gaps, % of the square"};
  for (const double radius : {0.3, 0.63}) {
    constexpr std::size_t patterns = 4000;
    const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, patterns, 1);
    if (!got) return;
    ErrorSums uncovered;
    double worst = missing;
    const SampleSets all = patterns_if_any(*got, radius, patterns);
    for (std::size_t set = 0; set < all.size(); ++set) {
      const double percent =
          100 * uncovered_area(all.column(set, 0), all.column(set, 1), radius, 200);
      uncovered.add(percent);
      worst = std::fmax(worst, percent);
    }
    const std::string row = fmt::format("radius {}", radius);
    table.add_mean(row, "mean", uncovered);
    table.add(row, "the worst of 4000", worst);
  }
}

/// How much less the RMSE is with 1,024 points.
TEST_CASE("bench table of gains", "[.bench-table]") {
  const Integrand& smooth = integrand("bump");
  BenchTable{"gain over independent points"}.add_ratio(
      "poisson_disk", std::sqrt(smooth.variance / 1024),
      errors_of(methods["poisson_disk"], smooth, 1024, 1000, 1));
}

}  // namespace
}  // namespace mc::measurements
