// The data of lab 5's plots of what one does with scrambled points: error bars from replicates, and
// the first n of a sequence that somebody stops early.

#include <cmath>
#include <numeric>

#include "checks/support/catch.hpp"
#include "checks/support/distributions.hpp"
#include "checks/support/exact_stratified.hpp"
#include "common/normal_quantile.hpp"
#include "measurements/halton/plot_integrals.hpp"
#include "measurements/halton/plot_points.hpp"

namespace mc::checks {
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

/// What became of estimates that are means of R replicates each.
struct Covered {
  double by_t = 0, by_z = 0;        ///< parts of the intervals that hold the exact value
  double reach = 0;                 ///< of an interval by Student's t, on average
  double reach_if_independent = 0;  ///< had the points been independent of each other
};
std::optional<Covered> covered(const std::vector<Points>& sets, std::size_t count,
                               const Integral& integral) {
  const std::size_t estimates = sets.size() / count;
  const auto r = static_cast<double>(count), all = static_cast<double>(estimates);
  const double t = t_quantile(r - 1), z = normal_quantile(0.975);
  Covered what;
  for (std::size_t k = 0; k < estimates; ++k) {
    std::vector<double> errors;
    double within = 0;
    std::size_t n = 0;
    for (std::size_t i = k * count; i < (k + 1) * count; ++i) {
      if (!sets[i]) return {};
      const Sums one = sums_over(*sets[i], integral);
      n = (*sets[i])[0].size();
      errors.push_back(one.errors / static_cast<double>(n));
      within += one.squares / static_cast<double>(n);
    }
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / r;
    double squares = 0;
    for (const double error : errors) squares += (error - mean) * (error - mean);
    const double bar = std::sqrt(squares / (r * (r - 1)));
    what.by_t += (std::abs(mean) <= t * bar) / all;
    what.by_z += (std::abs(mean) <= z * bar) / all;
    what.reach += t * bar / all;
    what.reach_if_independent +=
        z * std::sqrt((within / r - mean * mean) / (r * static_cast<double>(n))) / all;
  }
  return what;
}

/// 4,096 evaluations an estimate, shared out among R replicates; 400 estimates: coverage of 95 %
/// within 1.1 %. Rows: R, what z covers of normal values, and of each integrand what t covers, what
/// z covers, both reaches.
TEST_CASE("plot intervals from replicates", "[.plot]") {
  constexpr std::size_t evaluations = 4096, estimates = 400;
  const double z = normal_quantile(0.975);
  auto file = plot_file("replicates.tsv");
  for (std::size_t count = 2; count <= 64; count *= 2) {
    const std::size_t n = evaluations / count;
    const auto r = static_cast<double>(count);
    const auto sets =
        scrambled_sets_of(sobol_plot_points(n, {0, 1}), estimates * count, count << 24);
    std::vector<Number> row{r, f_tails(z * z, 1, r - 1).lower};
    for (const std::size_t i : {1u, 3u, 4u}) {
      const auto one = covered(sets, count, plot_integrals[i]);
      row.push_back(one ? Number(one->by_t) : Number{});
      row.push_back(one ? Number(one->by_z) : Number{});
      row.push_back(one ? Number(one->reach) : Number{});
      row.push_back(one ? Number(one->reach_if_independent) : Number{});
    }
    plot_row(file, row);
  }
}

/// The first n of 1,024 points, for exp(-x^2 - y^2), as lab 3 draws it: independent and shuffled
/// jittered points exactly, scrambled Sobol' points as the RMSE of 200 sets. Powers of two, and
/// three sizes between them.
TEST_CASE("plot the first points of a sequence", "[.plot]") {
  constexpr std::size_t most = 1024, sets = 200;
  const auto gaussian = [](double x) { return std::exp(-x * x); };
  const auto axis = strata_of(gaussian, 32);
  const WithinStrata cells = product_of(axis, axis);
  const double exact = mean_of(cells);
  const auto scrambled = scrambled_sets_of(sobol_plot_points(most, {0, 1}), sets, 99);
  auto file = plot_file("early.tsv");
  std::vector<double> sums(sets, 0.0);
  std::size_t done = 0;
  for (std::size_t quarter = 0; quarter <= 40; ++quarter) {
    const auto n =
        static_cast<std::size_t>(std::lround(std::exp2(static_cast<double>(quarter) / 4)));
    if (n == done) continue;
    const auto size = static_cast<double>(n);
    double squares = 0;
    for (std::size_t set = 0; set < sets && scrambled[set]; ++set) {
      const auto& columns = *scrambled[set];
      for (std::size_t i = done; i < n; ++i) {
        sums[set] += gaussian(columns[0][i]) * gaussian(columns[1][i]) - exact;
      }
      squares += sums[set] * sums[set] / sets;
    }
    done = n;
    plot_row(file, std::array{Number(size), Number(std::sqrt(independent_variance(cells, n))),
                              Number(std::sqrt(variance_of_first(cells, n))),
                              scrambled[0] ? Number(std::sqrt(squares) / size) : Number{}});
  }
}

}  // namespace
}  // namespace mc::checks
