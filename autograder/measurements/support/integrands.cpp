#include "measurements/support/integrands.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "checks/support/data.hpp"

namespace mc::checks {
namespace {

const double e = std::exp(1.0);

/// exp(x + y + …) over its mean.
template <std::size_t dims>
double smooth(std::span<const double> x) {
  static const double scale = std::pow(e - 1, -static_cast<double>(dims));
  double sum = 0;
  for (std::size_t d = 0; d < dims; ++d) sum += x[d];
  return scale * std::exp(sum);
}
/// E exp(2x) / (E exp(x))^2 of each coordinate.
double smooth_variance(std::size_t dims) {
  return std::pow((e * e - 1) / 2 / ((e - 1) * (e - 1)), static_cast<double>(dims)) - 1;
}

/// |x - 0.4| + |x + y - 1|: means (0.4^2 + 0.6^2)/2 and 1/3, squares (0.4^3 + 0.6^3)/3 and 1/6, and
/// of their product the mean of |x - 0.4| (x^2 - x + 1/2), F(1) - 2 F(0.4) + F(0) with F = x^4/4 -
/// 1.4 x^3/3 + 0.45 x^2 - 0.2 x: 361/3750.
constexpr double kinks_mean = 0.26 + 1. / 3, kinks_product = 361. / 3750;
constexpr double kinks_variance =
    (0.28 / 3 + 1. / 6 + 2 * kinks_product) / (kinks_mean * kinks_mean) - 1;
double kinks(std::span<const double> x) {
  return (std::abs(x[0] - 0.4) + std::abs(x[0] + x[1] - 1)) / kinks_mean;
}

/// 1 in a quarter of a disk of radius sqrt(0.7) < 1, which is 0.7 pi/4 of the square, over that.
const double disk = 0.7 * std::atan(1);
double edge(std::span<const double> x) {
  return x[0] * x[0] + x[1] * x[1] < 0.7 ? 1 / disk : 0;
}

double seconds_of_this_process() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::span<const BenchIntegrand> bench_integrands() {
  static const std::array<BenchIntegrand, 6> all{
      BenchIntegrand{"smooth 1D", 1, smooth_variance(1), smooth<1>},
      BenchIntegrand{"smooth 2D", 2, smooth_variance(2), smooth<2>},
      BenchIntegrand{"kinks 2D", 2, kinks_variance, kinks},
      BenchIntegrand{"edge 2D", 2, 1 / disk - 1, edge},
      BenchIntegrand{"smooth 4D", 4, smooth_variance(4), smooth<4>},
      BenchIntegrand{"smooth 8D", 8, smooth_variance(8), smooth<8>}};
  return all;
}

double mean_over(const BenchIntegrand& integrand,
                 std::span<const std::span<const double>> columns) {
  const std::size_t n = columns[0].size();
  std::array<double, 8> x{};
  double sum = 0;  // of deviations: their rounding errors are as small as they are
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < integrand.dims; ++d) x[d] = columns[d][i];
    sum += integrand.g({x.data(), integrand.dims}) - 1;
  }
  return 1 + sum / static_cast<double>(n);
}

double nanoseconds_of(const BenchIntegrand& integrand) {
  constexpr std::size_t n = 512;
  Rng rng(1);
  const auto x = uniform_values(rng, n * integrand.dims, 0, 1);
  std::vector<std::span<const double>> columns;
  for (std::size_t d = 0; d < integrand.dims; ++d) {
    columns.push_back(std::span(x).subspan(d * n, n));
  }
  volatile double sink = 0;
  std::vector<double> nanoseconds;
  for (int i = 0; i < 5; ++i) {
    constexpr int rounds = 400;
    const double start = seconds_of_this_process();
    for (int round = 0; round < rounds; ++round) sink = mean_over(integrand, columns);
    nanoseconds.push_back((seconds_of_this_process() - start) * 1e9 / (rounds * n));
  }
  (void)sink;
  std::sort(nanoseconds.begin(), nanoseconds.end());
  return nanoseconds[2];
}

}  // namespace mc::checks
