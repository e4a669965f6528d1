#pragma once
// What the bench measures. Like the data of plots: hidden test cases, the same measurements in the
// same jail as a check. Five kinds, which ./lab bench calls for by their tags:
//
//   [.bench-error]   once: what chance does to a result
//   [.bench-time]    several times, in turn with the other submissions: what a computer makes of it
//   [.bench-growth]  once: large N and many dimensions
//   [.bench-table]   once: numbers that belong in a separate small table (bench_table())
//   [.bench-table-time]  the same of times: several times, in turn with the other submissions
//
// Each number is a row that is written as soon as it is there (protocol/rows.hpp).

#include <limits>
#include <string>
#include <vector>

#include "measurements/support/integrands.hpp"
#include "measurements/support/methods.hpp"
#include "measurements/support/speed_data.hpp"

namespace mc::measurements {

/// Rows of kind error: each method on each integrand of its dimensions, at sizes 16, 64, ….
void bench_errors(const std::vector<Method>& methods);

/// Rows of kind time and integrand.
void bench_times(const std::vector<Method>& methods);

/// A row of kind error, relative to `exact`; and of kind time, of n values or points.
void bench_error(const std::string& what, const std::string& on, std::uint64_t dims,
                 std::uint64_t n, const ErrorSums& errors, double exact);
bool bench_time(const std::string& what, const std::string& on, std::uint64_t dims, std::uint64_t n,
                const Rounds& rounds);

/// Rows of kind growth and memory: of `rounds(n, R)`, the CPU time and the peak memory of R calls
/// with n, for n = `least`, 10 `least`, … `most` (or another factor).
struct Used {
  double seconds;
  std::size_t memory;
};
void bench_growth(const std::string& what, std::uint64_t dims, std::uint64_t most,
                  const std::function<std::optional<Used>(std::uint64_t, std::uint64_t)>& rounds,
                  std::uint64_t least = 1000, std::uint64_t factor = 10);

/// Rows of kind growth over 1, 2, 4, … 32 dimensions, 4,096 points each.
void bench_growth_of_dims(const std::string& what, const Method& method);

/// A cell of the table with this title, which ./lab bench prints as soon as there is a row of it.
struct Cell {
  std::string title, row, column;
  std::uint64_t n = 0;  ///< samples: columns are in this order, then in that of their first row
  double value = 0, error = std::numeric_limits<double>::quiet_NaN();
};
void bench_table(const Cell& cell);
/// An RMSE, if there is one.
void bench_table(const std::string& title, const std::string& row, const std::string& column,
                 std::uint64_t n, const ErrorSums& errors);

template <class Measured>
std::optional<Used> used_by(const Measured& measured) {
  if (!measured) return {};
  return Used{measured->cpu_seconds, measured->peak_memory};
}
}  // namespace mc::measurements
