#include "measurements/support/integrands.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <numbers>
#include <numeric>

#include "checks/support/domain.hpp"

namespace mc::measurements {
namespace {

const double e = std::exp(1.0);

using Point = std::span<const double>;

double exp_of_sum(Point x) {
  return std::exp(std::accumulate(x.begin(), x.end(), 0.0));
}
/// Its mean and its mean square are products of those of exp(x).
Integrand smooth(std::size_t dims, const char* formula) {
  const auto d = static_cast<double>(dims);
  const double mean = std::pow(e - 1, d), square = std::pow((e * e - 1) / 2, d);
  return {.name = "smooth " + std::to_string(dims) + 'D',
          .formula = formula,
          .dims = dims,
          .mean = mean,
          .g = exp_of_sum,
          .variance = square - mean * mean,
          .in_bench = true};
}

/// |x - 0.4| + |x + y - 1|: means (0.4^2 + 0.6^2)/2 and 1/3, squares (0.4^3 + 0.6^3)/3 and 1/6, and
/// of their product the mean of |x - 0.4| (x^2 - x + 1/2), F(1) - 2 F(0.4) + F(0) with F = x^4/4 -
/// 1.4 x^3/3 + 0.45 x^2 - 0.2 x: 361/3750.
constexpr double kinks_mean = 0.26 + 1. / 3, kinks_product = 361. / 3750;
constexpr double kinks_variance = 0.28 / 3 + 1. / 6 + 2 * kinks_product - kinks_mean * kinks_mean;

/// A quarter of a disk of radius sqrt(0.7) < 1.
const double disk = 0.7 * std::atan(1);

/// The mean of exp(-a x^2) over [0, 1].
double mean_of_bump(double a) {
  return std::sqrt(std::numbers::pi / a) / 2 * std::erf(std::sqrt(a));
}

double seconds_of_this_process() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

const std::vector<Integrand>& integrands() {
  static const std::vector<Integrand> all{
      smooth(1, "exp(x)"),
      smooth(2, "exp(x + y)"),
      {.name = "kinks 2D",
       .formula = "|x - 0.4| + |x + y - 1|",
       .dims = 2,
       .mean = kinks_mean,
       .g = [](Point x) { return std::abs(x[0] - 0.4) + std::abs(x[0] + x[1] - 1); },
       .variance = kinks_variance,
       .in_bench = true},
      {.name = "edge 2D",
       .formula = "1 where x² + y² < 0.7, else 0",
       .dims = 2,
       .mean = disk,
       .g = [](Point x) { return x[0] * x[0] + x[1] * x[1] < 0.7 ? 1.0 : 0.0; },
       .variance = disk - disk * disk,
       .in_bench = true},
      smooth(4, "exp(x + y + z + w)"),
      smooth(8, "exp of a sum of eight"),
      {.name = "bump",
       .formula = "exp(-x² - y²)",
       .dims = 2,
       .mean = std::pow(mean_of_bump(1), 2),
       .g = [](Point x) { return std::exp(-x[0] * x[0] - x[1] * x[1]); },
       .variance = std::pow(mean_of_bump(2), 2) - std::pow(mean_of_bump(1), 4)},
      // Where y < 0.65 - x/2: from 0.65 on the left to 0.15 on the right.
      {.name = "edge",
       .formula = "1 where x + 2y < 1.3, else 0",
       .dims = 2,
       .mean = 0.4,
       .g = [](Point x) { return x[0] + 2 * x[1] < 1.3 ? 1.0 : 0.0; }}};
  return all;
}

const Integrand& integrand(const std::string& name) {
  const auto found = std::find_if(integrands().begin(), integrands().end(),
                                  [&](const Integrand& one) { return one.name == name; });
  if (found == integrands().end()) throw std::out_of_range("no integrand " + name);
  return *found;
}

double error_of(const Integrand& integrand, const PointSet& points, std::size_t n,
                std::size_t first) {
  std::array<std::span<const double>, 8> columns;
  for (std::size_t d = 0; d < integrand.dims; ++d) columns[d] = points.column(first + d);
  std::array<double, 8> x{};
  double sum = 0;  // of deviations: their rounding errors are as small as they are
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < integrand.dims; ++d) x[d] = columns[d][i];
    sum += integrand.g({x.data(), integrand.dims}) - integrand.mean;
  }
  return sum / static_cast<double>(n);
}

double nanoseconds_of(const Integrand& integrand) {
  constexpr std::size_t n = 512;
  Rng rng(1);
  const PointSet points =
      sets_of(uniform_values(rng, n * integrand.dims, 0, 1), n, integrand.dims)[0];
  volatile double sink = 0;
  std::vector<double> nanoseconds;
  for (int i = 0; i < 5; ++i) {
    constexpr int rounds = 400;
    const double start = seconds_of_this_process();
    for (int round = 0; round < rounds; ++round) sink = error_of(integrand, points);
    nanoseconds.push_back((seconds_of_this_process() - start) * 1e9 / (rounds * n));
  }
  (void)sink;
  std::sort(nanoseconds.begin(), nanoseconds.end());
  return nanoseconds[2];
}

std::vector<ErrorSums> errors_of(const Method& method, const std::vector<Integrand>& integrands,
                                 std::uint64_t n, std::uint64_t replicates, std::uint64_t seed,
                                 std::uint64_t used) {
  std::vector<ErrorSums> errors(integrands.size());
  const std::uint64_t dims = integrands.at(0).dims;
  const std::uint64_t at_once = std::max<std::uint64_t>(1, most_coordinates / (n * dims));
  if (!method.is_random) replicates = 1;
  for (std::uint64_t done = 0; done < replicates; done += at_once) {
    const Sets sets = method.points(n, dims, std::min(at_once, replicates - done), seed + done);
    if (sets.empty()) return std::vector<ErrorSums>(integrands.size());
    for (const PointSet& set : sets) {
      const std::size_t size = used > 0 ? used : set.size();
      for (std::size_t i = 0; i < integrands.size(); ++i) {
        errors[i].add(error_of(integrands[i], set, size), static_cast<double>(size));
      }
    }
  }
  return errors;
}

ErrorSums errors_of(const Method& method, const Integrand& integrand, std::uint64_t n,
                    std::uint64_t replicates, std::uint64_t seed, std::uint64_t used) {
  return errors_of(method, std::vector{integrand}, n, replicates, seed, used)[0];
}

}  // namespace mc::measurements
