#include "measurements/support/integrands.hpp"

#include <algorithm>
#include <ctime>
#include <numbers>
#include <numeric>

namespace mc::measurements {
namespace {

/// exp(x + y + …): its mean and its mean square are products of those of exp(x).
Integrand smooth(std::size_t dims) {
  const auto d = static_cast<double>(dims);
  const double mean = std::pow(std::expm1(1.0), d), square = std::pow(std::expm1(2.0) / 2, d);
  return {"smooth " + std::to_string(dims) + 'D',
          dims,
          mean,
          [](View x) { return std::exp(std::accumulate(x.begin(), x.end(), 0.0)); },
          square - mean * mean,
          true};
}

/// |x - 0.4| + |x + y - 1|: means (0.4^2 + 0.6^2)/2 and 1/3, squares (0.4^3 + 0.6^3)/3 and 1/6, and
/// of their product the mean of |x - 0.4| (x^2 - x + 1/2), F(1) - 2 F(0.4) + F(0) with F = x^4/4 -
/// 1.4 x^3/3 + 0.45 x^2 - 0.2 x: 361/3750.
constexpr double kinks_mean = 0.26 + 1. / 3, kinks_product = 361. / 3750;
constexpr double kinks_variance = 0.28 / 3 + 1. / 6 + 2 * kinks_product - kinks_mean * kinks_mean;

/// x² + y² < 0.7: a quarter of a disk of radius sqrt(0.7) < 1.
const double disk = 0.7 * std::atan(1);

/// The mean of exp(-a x^2) over [0, 1].
double mean_of_bump(double a) {
  return std::sqrt(std::numbers::pi / a) / 2 * std::erf(std::sqrt(a));
}

}  // namespace

const std::vector<Integrand>& integrands() {
  static const std::vector<Integrand> all{
      smooth(1),
      smooth(2),
      {"kinks 2D", 2, kinks_mean,
       [](View x) { return std::abs(x[0] - 0.4) + std::abs(x[0] + x[1] - 1); }, kinks_variance,
       true},
      {"edge 2D", 2, disk, [](View x) { return x[0] * x[0] + x[1] * x[1] < 0.7 ? 1.0 : 0.0; },
       disk - disk * disk, true},
      smooth(4),
      smooth(8),
      {"bump", 2, std::pow(mean_of_bump(1), 2),
       [](View x) { return std::exp(-x[0] * x[0] - x[1] * x[1]); },
       std::pow(mean_of_bump(2), 2) - std::pow(mean_of_bump(1), 4)},
      // Where y < 0.65 - x/2: from 0.65 on the left to 0.15 on the right.
      {"edge", 2, 0.4, [](View x) { return x[0] + 2 * x[1] < 1.3 ? 1.0 : 0.0; }}};
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
  std::vector<View> columns;
  for (std::size_t d = 0; d < integrand.dims; ++d) columns.push_back(points.column(first + d));
  Values x(integrand.dims);
  double sum = 0;  // of deviations: their rounding errors are as small as they are
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d < integrand.dims; ++d) x[d] = columns[d][i];
    sum += integrand.g(x) - integrand.mean;
  }
  return sum / static_cast<double>(n);
}

double nanoseconds_of(const Integrand& integrand) {
  constexpr std::size_t n = 512, rounds = 400;
  Rng rng(1);
  const PointSet points =
      sets_of(uniform_values(rng, n * integrand.dims, 0, 1), n, integrand.dims)[0];
  volatile double sink = 0;
  Values nanoseconds;
  for (int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    for (std::size_t round = 0; round < rounds; ++round) sink = error_of(integrand, points, n);
    nanoseconds.push_back(static_cast<double>(std::clock() - start) * 1e9 /
                          (CLOCKS_PER_SEC * rounds * n));
  }
  (void)sink;
  return median(nanoseconds);
}

ErrorSums errors_of(const Sets& sets, const Integrand& integrand, std::size_t n,
                    std::size_t first) {
  ErrorSums errors;
  for (const PointSet& set : sets) errors.add(error_of(integrand, set, n, first));
  return errors;
}

std::vector<ErrorSums> errors_of(const Method& method, const std::vector<Integrand>& integrands,
                                 Count n, Count replicates, Count seed, Count used) {
  std::vector<ErrorSums> errors(integrands.size());
  const auto add = [&](const PointSet& set) {
    const std::size_t size = used > 0 ? used : set.size();
    for (std::size_t i = 0; i < integrands.size(); ++i) {
      errors[i].add(error_of(integrands[i], set, size), static_cast<double>(size));
    }
  };
  const Count count = method.traits.is_random ? replicates : 1;
  if (for_each_set(method, n, integrands.at(0).dims, count, seed, add)) return errors;
  return std::vector<ErrorSums>(integrands.size());
}

ErrorSums errors_of(const Method& method, const Integrand& integrand, Count n, Count replicates,
                    Count seed, Count used) {
  return errors_of(method, std::vector{integrand}, n, replicates, seed, used)[0];
}

}  // namespace mc::measurements
