// Lab 4 in the bench: best candidates and Poisson disks; and numbers that the handout quotes. Those
// of other ways than the solutions' are of mistakes: ten_candidates, bridson_alone.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "checks/support/catch.hpp"
#include "checks/support/disks.hpp"
#include "measurements/blue_noise/methods.hpp"
#include "measurements/support/bench_data.hpp"

namespace mc::measurements {
namespace {

std::vector<Method> benched() {
  return methods_of(methods, {"best_candidate", "poisson_disk"});
}

TEST_CASE("bench error", "[.bench-error]") {
  bench_errors(benched());
}
TEST_CASE("bench time", "[.bench-time]") {
  bench_times(benched());
}
TEST_CASE("bench growth", "[.bench-growth]") {
  const auto grow = [](const char* name, unsigned task, std::uint64_t most) {
    bench_growth(
        name, 2, most,
        [=](std::uint64_t n, std::uint64_t rounds) {
          return used_by(TRY_MEASURE_WITH(large, repeat, task, n, rounds, 1));
        },
        256, 4);
  };
  grow("best candidate", 2, 4096);
  grow("Poisson disk", 3, 65536);
}

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
void write(const std::string& title, const std::string& row, const std::string& column,
           const Mean& mean) {
  if (mean.count == 0) return;
  bench_table({title, row, column, 0, mean.value(), mean.count > 1 ? mean.error() : nan});
}

constexpr std::size_t low_n = 256, low_sets = 200;
constexpr int low_kmax = 8;  // sqrt(n) / 2

/// The mean power for 0 < |k| <= sqrt(n)/2.
double power_of(std::span<const double> x, std::span<const double> y) {
  return low_band(spectrum_of(x, y, low_kmax), low_n);
}
void write_power(const std::string& row, const Mean& power) {
  write("low frequencies, N = 256", row, "power", power);
}
Mean exactly(double value) {
  return {1, value, value * value, value};
}

/// The power that jittered points, one in each of side x side cells, have on average at k: 1 -
/// sinc(kx / side)^2 sinc(ky / side)^2. A cell's mean wave has the size sinc sinc; what cells have
/// in common cancels, each cell's own remainder does not.
double jittered_power(int kx, int ky, int side) {
  const auto sinc = [&](int k) {
    const double turn = std::numbers::pi * k / side;
    return k == 0 ? 1 : std::sin(turn) / turn;
  };
  return 1 - std::pow(sinc(kx) * sinc(ky), 2);
}

double jittered_low_power(int side) {
  Spectrum spectrum{low_kmax, {}};
  for (int ky = -low_kmax; ky <= low_kmax; ++ky) {
    for (int kx = -low_kmax; kx <= low_kmax; ++kx) {
      spectrum.power.push_back(jittered_power(kx, ky, side));
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
  write_power("independent, exact", exactly(1));
  write_power("jittered, exact", exactly(jittered_low_power(16)));
  write_power("Halton, exact", exactly(power_of(halton_axis(2), halton_axis(3))));
  Mean power, closest, of_disks;
  for (const PointSet& set : method(methods, "best_candidate").points(low_n, 2, low_sets, 1)) {
    power.add(power_of(set.column(0), set.column(1)));
    closest.add(least_distance(set.column(0), set.column(1)) / lattice_distance(low_n));
  }
  write_power("best_candidate", power);
  // In parts of the distance in the densest pattern.
  write("closest two of 256", "best_candidate", "distance", closest);
  for (const PointSet& set : method(methods, "poisson_disk").points(low_n, 2, low_sets, 1)) {
    of_disks.add(power_of(set.column(0), set.column(1)));
  }
  write_power("poisson_disk", of_disks);
}

TEST_CASE("bench table of gaps", "[.bench-table]") {
  for (const double radius : {0.3, 0.63}) {
    constexpr std::size_t patterns = 4000;
    const auto got = TRY_MEASURE_WITH(large, poisson_disk, radius, patterns, 1);
    if (!got) return;
    Mean uncovered;
    const SampleSets all = patterns_if_any(*got, radius, patterns);
    for (std::size_t set = 0; set < all.size(); ++set) {
      uncovered.add(100 * uncovered_area(all.column(set, 0), all.column(set, 1), radius, 200));
    }
    const std::string title = "gaps, % of the square", row = fmt::format("radius {}", radius);
    write(title, row, "mean", uncovered);
    if (uncovered.count > 0) bench_table({title, row, "the worst of 4000", 0, uncovered.most});
  }
}

/// How much less the RMSE is with 1,024 points.
TEST_CASE("bench table of gains", "[.bench-table]") {
  const Integrand& smooth = integrand("bump");
  const ErrorSums errors = errors_of(method(methods, "poisson_disk"), smooth, 1024, 1000, 1);
  if (errors.count == 0) return;
  const double ratio = std::sqrt(smooth.variance / 1024) / errors.rmse();
  bench_table({"gain over independent points", "poisson_disk", "ratio", 0, ratio,
               ratio * errors.standard_error() / errors.rmse()});
}

}  // namespace
}  // namespace mc::measurements
