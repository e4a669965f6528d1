#pragma once
// What the bench measures. Like the data of plots: hidden test cases, the same measurements in the
// same jail as a check. Three kinds, which ./lab bench calls for by their tags:
//
//   [.bench-error]   once: what chance does to a result
//   [.bench-time]    several times, in turn with the other submissions: what a computer makes of it
//   [.bench-growth]  once: large N and many dimensions
//
// Each figure is a row that is written as soon as it is there:
//
//   kind, what, on what, dims, n, value, its standard error or NaN    (separated by tabs)
//
//   error      a point set, an integrand: the root mean square error of the mean over n points
//   time       a point set or an algorithm: nanoseconds a point, or a value
//   integrand  nanoseconds a value
//   variance   of an integrand's value at a uniform point
//   digits     an algorithm, data: decimal digits of its result that are right
//   growth     an algorithm, "n" or "dims": seconds a call
//   memory     an algorithm: bytes, at their most
//   speed        for check and grade, [.speed], a speed task ("1.8 moments"): nanoseconds a value
//   speed error  and the error of its points, on an integrand, if it makes any

#include <functional>
#include <string>
#include <vector>

#include "checks/integrands.hpp"
#include "checks/plot_data.hpp"

namespace mc::checks {

struct BenchRow {
  std::string kind, what, on = "";
  std::uint64_t dims = 0, n = 0;
  double value = 0, error = std::numeric_limits<double>::quiet_NaN();
};

/// Appends to the file that ./lab bench reads, and tells it at once.
void bench_row(const BenchRow& row);

/// CPU time of so many rounds; nothing where the task is not written.
using Rounds = std::function<std::optional<double>(std::uint64_t)>;

/// Seconds a round, seen from outside: the CPU time of 2R rounds less that of R, R so large that
/// this is about 25 ms. One such difference: ./lab bench comes back for more of them.
std::optional<double> seconds_once(const Rounds& run);

/// Rows of kind speed, if `task` is one that MC_SPEED_TASKS names (the grader does: those that
/// passed): `rounds` makes `values` numbers or points each time. A seventh of a second.
void bench_speed(const std::string& task, const std::string& name, std::uint64_t values,
                 const Rounds& rounds);

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
      points;
  /// CPU seconds of making n points so many times.
  std::function<std::optional<double>(std::uint64_t n, std::uint64_t dims, std::uint64_t rounds)>
      rounds;
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

/// A row of kind speed error: of n points of the plane, integrating exp(x + y).
void bench_speed_error(const std::string& task, const std::string& name,
                       const BenchSampler& sampler, std::uint64_t n);

/// Rows of kind growth over 1, 2, 4, … 32 dimensions, 4,096 points each.
void bench_growth_of_dims(const BenchSampler& sampler);

/// What large sizes may use: below 1 GB, all of the bench.
inline const grader::Limits large{120, 240, std::size_t{1000} << 20};

template <class Measured>
std::optional<Used> used_by(const Measured& measured) {
  if (!measured) return {};
  return Used{measured->cpu_seconds, measured->peak_memory};
}
template <class Measured>
std::optional<double> cpu_seconds_of(const Measured& measured) {
  if (!measured) return {};
  return measured->cpu_seconds;
}

}  // namespace mc::checks
