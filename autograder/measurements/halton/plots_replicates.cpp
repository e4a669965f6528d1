// The data of lab 5's plot of error bars from replicates of scrambled points.

#include <cmath>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/halton/methods.hpp"
#include "measurements/support/plot_data.hpp"

namespace mc::measurements {
namespace {

/// The distance within which Student's t with so many degrees of freedom lies with probability
/// 0.95: the root of a quantile of F.
double t_quantile(double degrees) {
  double low = 1, high = 400;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (f_tails(middle, 1, degrees).lower < 0.95 ? low : high) = middle;
  }
  return std::sqrt(low);
}

/// What became of estimates that are means of R replicates each: the parts of the intervals by
/// Student's t and by z that hold the exact value, the mean half-length by t, and had the points
/// been independent of each other.
Row covered(const Sets& sets, std::size_t count, const Integrand& integrand) {
  if (sets.empty()) return Row(4);
  const auto r = static_cast<double>(count), all = static_cast<double>(sets.size()) / r;
  const double t = t_quantile(r - 1), z = normal_quantile(0.975);
  double by_t = 0, by_z = 0, reach = 0, reach_if_independent = 0;
  for (std::size_t first = 0; first < sets.size(); first += count) {
    std::vector<double> errors(count);
    for (std::size_t i = 0; i < count; ++i) errors[i] = error_of(integrand, sets[first + i]);
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / r;
    double squares = 0;
    for (const double error : errors) squares += (error - mean) * (error - mean);
    const double bar = std::sqrt(squares / (r * (r - 1)));
    const double points = r * static_cast<double>(sets[first].size());
    by_t += (std::abs(mean) <= t * bar) / all;
    by_z += (std::abs(mean) <= z * bar) / all;
    reach += t * bar / all;
    reach_if_independent += z * std::sqrt(integrand.variance / points) / all;
  }
  return {by_t, by_z, reach, reach_if_independent};
}

/// 4,096 evaluations an estimate, shared out among R replicates; 400 estimates: coverage of 95 %
/// within 1.1 %.
TEST_CASE("plot intervals from replicates", "[.plot]") {
  constexpr std::size_t evaluations = 4096, estimates = 400;
  const double z = normal_quantile(0.975);
  Names columns{"R", "z_exact"};
  for (const char* of : {"smooth", "kinks", "edge"}) {
    for (const char* what : {"t_", "z_", "reach_", "independent_"}) {
      columns.push_back(std::string(what) + of);
    }
  }
  auto file = plot_file("replicates.tsv", columns);
  for (std::size_t count = 2; count <= 64; count *= 2) {
    const Sets sets = sets_in_parts(method(methods, "scrambled_sobol"), evaluations / count, 2,
                                    estimates * count, count);
    Row row{static_cast<double>(count), f_tails(z * z, 1, static_cast<double>(count - 1)).lower};
    for (const char* name : {"smooth 2D", "kinks 2D", "edge 2D"}) {
      const Row one = covered(sets, count, integrand(name));
      row.insert(row.end(), one.begin(), one.end());
    }
    plot_row(file, row);
  }
}

}  // namespace
}  // namespace mc::measurements
