#pragma once
// What the bench measures. Like the data of plots: hidden test cases, the same measurements in the
// same jail as a check. Five kinds, which ./lab bench calls for by their tags:
//
//   [.bench-error]   once: what chance does to a result
//   [.bench-time]    several times, in turn with the other submissions: what a computer makes of it
//   [.bench-growth]  once: large N and many dimensions
//   [.bench-table]   once: figures that belong into a small table of their own (bench_table())
//   [.bench-table-time]  the same of times: several times, in turn with the other submissions
//
// Each figure is a row that is written as soon as it is there (protocol/rows.hpp).

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "measurements/support/integrands.hpp"
#include "measurements/support/plot_data.hpp"
#include "measurements/support/speed_data.hpp"
#include "protocol/rows.hpp"

namespace mc::checks {

/// Seconds a round, seen from outside: the CPU time of 2R rounds less that of R, R so large that
/// this is about 25 ms. One such difference: ./lab bench comes back for more of them. Nothing where
/// what came back was wrong.
std::optional<double> seconds_once(const Rounds& run);

/// Errors of independent replicates: sums of their squares, and of those squared.
struct ErrorSums {
  double count = 0, squares = 0, fourths = 0, sixths = 0, eighths = 0;
  void add(double error) {
    const double square = error * error;
    ++count;
    squares += square;
    fourths += square * square;
    sixths += square * square * square;
    eighths += square * square * square * square;
  }
  double rmse() const { return std::sqrt(squares / count); }
  /// Of the RMSE: that of the mean square, by the delta method.
  double standard_error() const {
    const double mean = squares / count;
    return std::sqrt(std::max(0.0, fourths / count - mean * mean) / count) / (2 * rmse());
  }
  /// About the exact value: 3 where the errors are normal.
  double kurtosis() const { return fourths * count / (squares * squares); }
  /// Of the kurtosis k = m4 / m2^2, by the delta method: an error x moves it by
  /// x^4 / m2^2 - 2 k x^2 / m2 + k. (Where the errors are normal this is sqrt(24 / count).) Where
  /// a few huge errors make k, there are too few of them in most samples, and this is too small.
  double kurtosis_error() const {
    const double m2 = squares / count, k = kurtosis();
    const double variance = eighths / count / std::pow(m2, 4) -
                            4 * k * sixths / count / std::pow(m2, 3) + 4 * k * k * k - k * k;
    return std::sqrt(std::max(0.0, variance) / count);
  }
};

/// Columns of one point set after another; nothing where the task is not written.
struct PointSets {
  std::size_t n = 0, dims = 0;
  std::vector<double> values;  ///< set by set, in each of them column by column
};

/// A way of making points.
struct BenchSampler {
  std::string name;
  std::vector<std::uint64_t> dims;  ///< that it is benched in
  std::uint64_t most = 65536;       ///< points
  bool power_of_root = false;       ///< only where n is the dims-th power of a whole number
  /// `sets` sets of n points, by that seed.
  std::function<std::optional<PointSets>(std::uint64_t n, std::uint64_t dims, std::uint64_t sets,
                                         std::uint64_t seed)>
      points = {};
  /// CPU seconds of making n points so many times.
  std::function<std::optional<double>(std::uint64_t n, std::uint64_t dims, std::uint64_t rounds)>
      rounds = {};
  bool same_for_all_n = false;  ///< what a point costs: then it is timed at one n only
};

/// Sizes 16, 64, … of which errors are measured.
std::vector<std::uint64_t> bench_sizes(const BenchSampler& sampler, std::uint64_t dims);

/// Rows of kind error: each sampler on each integrand of its dimensions, at each size.
void bench_errors(const std::vector<BenchSampler>& samplers);

/// The same of sets of points of the plane that are not all of one size.
void bench_errors_of_sets(const std::string& what, std::span<const std::uint64_t> sizes,
                          std::span<const double> x, std::span<const double> y);

/// Rows of kind time and integrand.
void bench_times(const std::vector<BenchSampler>& samplers);

/// Rows of kind growth and memory: of `rounds(n, R)`, the CPU time and the peak memory of R calls
/// with n, for n = `least`, 10 `least`, … `most` (or another factor).
struct Used {
  double seconds;
  std::size_t memory;
};
void bench_growth(const std::string& what, std::uint64_t dims, std::uint64_t most,
                  const std::function<std::optional<Used>(std::uint64_t, std::uint64_t)>& rounds,
                  std::uint64_t least = 1000, std::uint64_t factor = 10);

/// The same as in speed_data.hpp, of a sampler's points.
inline void bench_speed_error(const std::string& task, const std::string& name,
                              const BenchSampler& sampler, std::uint64_t n) {
  bench_speed_error(task, name, n, [&](std::uint64_t sets) -> std::optional<std::vector<double>> {
    auto got = sampler.points(n, 2, sets, 1);
    if (!got) return {};
    return std::move(got->values);
  });
}

/// A figure of the table with this title, which ./lab bench prints as soon as there is a row of it.
struct Cell {
  std::string title, row, column;
  std::uint64_t n = 0;  ///< samples: columns stand in this order, then in that of their first row
  double value = 0, error = std::numeric_limits<double>::quiet_NaN();
};
inline void bench_table(const Cell& cell) {
  bench_row({"table " + cell.title, cell.row, cell.column, 0, cell.n, cell.value, cell.error});
}

/// Rows of kind growth over 1, 2, 4, … 32 dimensions, 4,096 points each.
void bench_growth_of_dims(const BenchSampler& sampler);

/// What large sizes may use: below 1 GB, all of the bench.
inline const sandbox::Limits large{120, 240, std::size_t{1000} << 20};

template <class Measured>
std::optional<Used> used_by(const Measured& measured) {
  if (!measured) return {};
  return Used{measured->cpu_seconds, measured->peak_memory};
}
}  // namespace mc::checks
